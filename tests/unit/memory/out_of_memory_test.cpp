// Memory ends at every single place: nothing leaks, nothing crashes, and what was there before is whole.

#include "engine/core/out_of_memory.hpp"

#include <gtest/gtest.h>

#include <mutex>

#include "engine/bake/bake.hpp"
#include "engine/core/file.hpp"
#include "engine/core/thread_pool.hpp"
#include "engine/io/assets.hpp"
#include "engine/io/image.hpp"
#include "engine/io/project_json.hpp"
#include "engine/model/edit.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/unit/io/gltf_fixture.hpp"
#include "tests/unit/io/project_fixture.hpp"
#include "tests/unit/memory/failing_new.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

using testing::failEach;

/// A field of few cells, so that its wind is soon made.
Project smallProject() {
  Project project;
  FieldSettings field;
  field.size = {48, 32};
  field.resolution = {48, 32};
  project.field = std::make_shared<FieldSettings>(field);
  return project;
}

// The JSON library takes a little memory to give a document back, in destructors that end the program where there is
// none; so of readers only large wishes fail here. As much is kept aside by the programs for such a moment.
constexpr std::size_t kLargeBytes = 400'000;
constexpr std::size_t kFrameBytes = 4'000;  // larger than what its manifest takes, smaller than a frame of wind

/// Its lists and its text are larger than that, what the library needs to give them back is not.
Project largeProject() {
  WindGraph graph;
  for (Id id = 1; id <= 10000; ++id) {
    Point point;
    point.id = id;
    point.position = {static_cast<float>(id) * 0.01f, 0};
    graph.points.push_back(point);
  }
  Project project;
  project.graph = std::make_shared<WindGraph>(std::move(graph));
  return project;
}

std::string namesIn(const fs::path& folder) {
  std::string names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    names += entry.path().filename().string() + " ";
  return names;
}

Project plantedProject(const fs::path& folder) {
  EXPECT_TRUE(writeFileAtomically(folder / "tuft.glb", testing::standingTriangle().glb()).ok());
  EXPECT_TRUE(writePng(folder / "mask.png", Image(4, 4, 1)).ok());
  Project project;
  Species tuft;
  tuft.id = 1'000'000;
  tuft.shape = PlantShape::Mesh;
  tuft.file = "tuft.glb";
  project.species = std::make_shared<std::vector<Species>>(1, tuft);
  GrassSettings grass = *project.grass;
  grass.densityMap = "mask.png";
  project.grass = std::make_shared<GrassSettings>(grass);
  return project;
}

}  // namespace

TEST(OutOfMemory, IsAnErrorWhereItIsTurnedIntoOne) {
  const auto failing = []() -> Status { throw std::bad_alloc(); };
  const Status status = orOutOfMemory("hills.png", failing);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, ErrorKind::Machine);
  EXPECT_EQ(status.error().text(), "not enough memory for hills.png");
  EXPECT_FALSE(orOutOfMemory("it", []() -> Status { throw std::length_error("vector"); }).ok());
}

TEST(OutOfMemory, ReadingAProjectLeaksNothing) {
  const std::string text = writeProject(largeProject());
  const long runs = failEach([&] { static_cast<void>(parseProject(text, "large")); }, [] {}, 1, kLargeBytes);
  EXPECT_GE(runs, 1);
}

TEST(OutOfMemory, LoadingAProjectIsAnError) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.wind.json";
  Project project = plantedProject(folder.path());
  project.graph = largeProject().graph;
  ASSERT_TRUE(saveProject(project, file).ok());
  bool whole = false;
  const long runs = failEach(
      [&] {
        const Result<LoadedProject> loaded = loadProject(file);
        whole = loaded.ok() && loaded->missing.empty();
        if (!loaded) {
          EXPECT_EQ(loaded.error().kind, ErrorKind::Machine);
          EXPECT_NE(loaded.error().text().find("not enough memory for"), std::string::npos) << loaded.error().text();
        }
      },
      [] {}, 1, kLargeBytes);
  EXPECT_TRUE(whole) << "the last run had all the memory that it wanted";
  EXPECT_GE(runs, 2);
}

TEST(OutOfMemory, AFailedEditLeavesTheProjectAsItWas) {
  const Result<LoadedProject> loaded = parseProject(kRichProject, "rich");
  ASSERT_TRUE(loaded.ok());
  const std::string before = writeProject(loaded->project);
  Probe probe;
  probe.id = nextFreeId(loaded->project);
  const Edit edit{"Add a probe", {Put<Probe>{probe}, SetName{"a name that is longer than short strings are"}}, {}};
  const long runs = failEach([&] { static_cast<void>(applyEdit(loaded->project, edit)); },
                             [&] { ASSERT_EQ(writeProject(loaded->project), before); });
  EXPECT_GT(runs, 10);
}

TEST(OutOfMemory, AFailedSaveLeavesTheOldFileWhole) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "a.wind.json";
  ASSERT_TRUE(saveProject(smallProject(), file).ok());
  const std::string before = readFile(file).value();
  const long runs = failEach([&] { static_cast<void>(saveProject(smallProject(), file)); },
                             [&] {
                               ASSERT_EQ(readFile(file).value(), before);
                               ASSERT_LE(folder.entries(), 2) << namesIn(folder.path());
                             });
  EXPECT_GT(runs, 50);
}

TEST(OutOfMemory, APictureLeaksNothing) {
  const TemporaryFolder folder;
  const Image image(8, 8, 3);
  const fs::path file = folder.path() / "a.png";
  EXPECT_GT(failEach([&] { static_cast<void>(writePng(file, image)); }, [&] { ASSERT_EQ(folder.entries(), 1); }), 3);
  EXPECT_GT(failEach([&] { static_cast<void>(readPng(file)); }, [] {}), 3);
}

TEST(OutOfMemory, AFailedBakeLeavesNoFiles) {
  const TemporaryFolder folder;
  const Project project = smallProject();
  BakeRequest request;
  request.folder = folder.path() / "out";
  request.plan.frames = 3;
  request.plan.fps = 30;
  for (const char* name : {"npy", "png", "windpack"}) {
    request.formats.push_back(writerKindNamed(name));
    ASSERT_NE(request.formats.back(), nullptr) << name;
  }
  bool done = false;
  std::string why(500, ' ');  // taken before anything is counted
  const auto bakeOnce = [&] {
    done = false;
    SimulationOptions options;
    options.backend = Backend::Cpu;
    options.threads = 2;
    const auto simulation = Simulation::create(project, options);
    if (!simulation) return;
    const Result<BakeReport> report = bake(**simulation, request, {});
    done = report.ok();
    if (!done) why = report.error().text();
  };
  const long runs = failEach(
      bakeOnce,
      [&] {
        ASSERT_EQ(fs::exists(request.folder / "manifest.json"), done);
        ASSERT_TRUE(done || !fs::exists(request.folder)) << "a folder that was made for it stays";
        fs::remove_all(request.folder);
      },
      3, kFrameBytes);
  EXPECT_TRUE(done) << "the last run had all the memory that it wanted: " << why;
  EXPECT_GT(runs, 20);
}

TEST(OutOfMemory, AThreadOfAPoolHandsItToWhoCalled) {
  ThreadPool pool(4);
  for (int round = 0; round < 20; ++round) {
    EXPECT_THROW(pool.parallelFor(64,
                                  [&](int chunk) {
                                    if (chunk % 7 == round % 7) throw std::bad_alloc();
                                  }),
                 std::bad_alloc);
    int sum = 0;
    std::mutex mutex;
    pool.parallelFor(10, [&](int chunk) {
      const std::lock_guard lock(mutex);
      sum += chunk;
    });
    EXPECT_EQ(sum, 45) << "the pool goes on";
  }
}

}  // namespace windloom
