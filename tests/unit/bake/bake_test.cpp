#include "engine/bake/bake.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/bake/response.hpp"
#include "engine/bake/work_folder.hpp"
#include "engine/core/file.hpp"
#include "engine/io/npy.hpp"
#include "engine/io/sha256.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

/// A small field in which one arrow blows on top of an ambient wind, so that frames differ.
Project smallProject() {
  Project project;
  FieldSettings field;
  field.centre = {10, 0};
  field.size = {24, 18};
  field.resolution = {24, 18};
  field.timeStep = 1.0f / 60.0f;
  project.field = std::make_shared<FieldSettings>(field);
  AmbientWind ambient;
  ambient.speed = 1.0f;
  project.ambient = std::make_shared<AmbientWind>(ambient);
  WindGraph graph;
  graph.points = {{1, "", {4, 0}, false, {}}, {2, "", {14, 3}, false, {}}};
  Arrow arrow;
  arrow.id = 3;
  arrow.from = 1;
  arrow.to = 2;
  graph.arrows = {arrow};
  project.graph = std::make_shared<WindGraph>(graph);
  return project;
}

std::unique_ptr<Simulation> simulate(const Project& project) {
  SimulationOptions options;
  options.backend = Backend::Cpu;
  options.threads = 1;
  Result<std::unique_ptr<Simulation>> simulation = Simulation::create(project, options);
  EXPECT_TRUE(simulation) << simulation.error().text();
  return std::move(*simulation);
}

BakeRequest requestFor(const fs::path& folder, std::initializer_list<const char*> formats, const RecordPlan& plan) {
  BakeRequest request;
  request.folder = folder;
  request.plan = plan;
  request.sidecars = false;
  for (const char* name : formats) request.formats.push_back(writerKindNamed(name));
  return request;
}

BakeReport mustBake(const Project& project, const BakeRequest& request) {
  const Result<BakeReport> report = bake(*simulate(project), request, {});
  EXPECT_TRUE(report) << report.error().text();
  return *report;
}

NpyArray readWind(const fs::path& folder) {
  return readNpy(folder / "wind.npy").value();
}

nlohmann::json readManifest(const fs::path& folder) {
  return nlohmann::json::parse(readFile(folder / "manifest.json").value());
}

}  // namespace

TEST(Bake, FramesAreTheFieldAtTheirTimes) {
  const TemporaryFolder folder;
  const RecordPlan plan{0.1, 20, 4, 0};
  mustBake(smallProject(), requestFor(folder.path(), {"npy"}, plan));
  const NpyArray wind = readWind(folder.path());
  EXPECT_EQ(wind.shape, (std::vector<std::size_t>{4, 18, 24, 2}));
  const auto simulation = simulate(smallProject());
  for (int frame = 0; frame < 4; ++frame) {
    simulation->runTo(0.1 + frame / 20.0);
    EXPECT_EQ(simulation->steps(), 6 + 3 * frame);
    const std::vector<glm::vec2>& cells = simulation->velocity();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      ASSERT_EQ(wind.values[(static_cast<std::size_t>(frame) * cells.size() + i) * 2], cells[i].x);
      ASSERT_EQ(wind.values[(static_cast<std::size_t>(frame) * cells.size() + i) * 2 + 1], cells[i].y);
    }
  }
}

TEST(Bake, ALoopBlendsTheFramesBehindItsEndIntoItsStart) {
  const TemporaryFolder plainFolder, loopFolder;
  mustBake(smallProject(), requestFor(plainFolder.path(), {"npy"}, {0.0, 20, 10, 0}));
  BakeRequest request = requestFor(loopFolder.path(), {"npy"}, {0.0, 20, 8, 2});
  request.loop = true;
  mustBake(smallProject(), request);
  const NpyArray plain = readWind(plainFolder.path()), loop = readWind(loopFolder.path());
  EXPECT_EQ(loop.shape[0], 8u);
  const std::size_t size = loop.values.size() / 8;
  const auto at = [&](const NpyArray& wind, std::size_t frame, std::size_t i) { return wind.values[frame * size + i]; };
  double seam = 0, unblended = 0;
  for (std::size_t i = 0; i < size; ++i) {
    EXPECT_EQ(at(loop, 0, i), at(plain, 8, i)) << "the first frame is the one behind the last";
    EXPECT_NEAR(at(loop, 1, i), 0.5f * (at(plain, 9, i) + at(plain, 1, i)), 1e-5f);
    for (std::size_t frame = 2; frame < 8; ++frame) EXPECT_EQ(at(loop, frame, i), at(plain, frame, i));
    seam = std::max(seam, static_cast<double>(std::abs(at(loop, 0, i) - at(loop, 7, i))));
    unblended = std::max(unblended, static_cast<double>(std::abs(at(plain, 7, i) - at(plain, 0, i))));
  }
  EXPECT_LT(seam, 0.5 * unblended) << "no jump from the end to the start";
  const nlohmann::json manifest = readManifest(loopFolder.path());
  EXPECT_EQ(manifest["time"]["loop"], true);
  EXPECT_EQ(manifest["time"]["crossfade"], 2);
}

TEST(Bake, WritesAllFormatsAndAManifestThatNamesThem) {
  const TemporaryFolder folder;
  const BakeReport report =
      mustBake(smallProject(), requestFor(folder.path() / "deep" / "er", {"npy", "png", "windpack"}, {0, 10, 3, 0}));
  const fs::path out = folder.path() / "deep" / "er";
  const nlohmann::json manifest = readManifest(out);
  EXPECT_EQ(manifest["format"], "windpack");
  EXPECT_EQ(manifest["units"], "m/s");
  EXPECT_EQ(manifest["grid"], nlohmann::json({24, 18}));
  EXPECT_EQ(manifest["bounds"]["min"], nlohmann::json({-2, -9}));
  EXPECT_EQ(manifest["bounds"]["max"], nlohmann::json({22, 9}));
  EXPECT_EQ(manifest["cell"], nlohmann::json({1, 1}));
  EXPECT_EQ(manifest["time"]["fps"], 10);
  EXPECT_EQ(manifest["time"]["frames"], 3);
  EXPECT_EQ(manifest["zero_code"], 128);
  EXPECT_EQ(manifest["rowOrder"], "ascending");
  ASSERT_EQ(manifest["files"].size(), 5u);
  std::uint64_t bytes = fs::file_size(out / "manifest.json");
  for (const nlohmann::json& file : manifest["files"]) {
    const fs::path path = out / file["path"].get<std::string>();
    EXPECT_EQ(sha256OfFile(path).value(), file["sha256"]) << path;
    bytes += fs::file_size(path);
  }
  EXPECT_EQ(report.bytes, bytes);
  EXPECT_EQ(report.files.size(), 6u);
  EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), 6);
  // The scale holds the fastest cell of all frames, with no more than a hundredth to spare.
  float fastest = 0;
  const NpyArray wind = readWind(out);
  for (std::size_t i = 0; i < wind.values.size(); i += 2) {
    fastest = std::max(fastest, glm::length(glm::vec2(wind.values[i], wind.values[i + 1])));
  }
  EXPECT_GE(manifest["vmax"].get<float>(), fastest - 1e-4f);
  EXPECT_LE(manifest["vmax"].get<float>(), fastest + 0.0101f);
}

TEST(Bake, ThePresetDecidesTheManifestsFrameButNotTheArraysOne) {
  const TemporaryFolder folder;
  BakeRequest request = requestFor(folder.path(), {"npy", "png"}, {0, 10, 1, 0});
  request.preset = Preset::Unreal;
  request.fullScale = 5.0f;
  mustBake(smallProject(), request);
  const nlohmann::json manifest = readManifest(folder.path());
  EXPECT_EQ(manifest["frame"]["handedness"], "left");
  EXPECT_EQ(manifest["frame"]["up"], "+Z");
  EXPECT_EQ(manifest["units"], "cm/s");
  EXPECT_EQ(manifest["vmax"], 500);
  EXPECT_EQ(manifest["bounds"]["max"], nlohmann::json({2200, 900}));
  EXPECT_EQ(manifest["files"][0]["path"], "wind.npy");
  EXPECT_EQ(manifest["files"][0]["units"], "m/s");
  EXPECT_EQ(manifest["files"][0]["bounds"]["max"], nlohmann::json({22, 9}));
}

TEST(Bake, AnotherResolutionKeepsTheMeanWind) {
  const TemporaryFolder full, small;
  mustBake(smallProject(), requestFor(full.path(), {"npy"}, {0.2, 10, 1, 0}));
  BakeRequest request = requestFor(small.path(), {"npy"}, {0.2, 10, 1, 0});
  request.resolution = glm::ivec2(7, 5);
  mustBake(smallProject(), request);
  const NpyArray a = readWind(full.path()), b = readWind(small.path());
  EXPECT_EQ(b.shape, (std::vector<std::size_t>{1, 5, 7, 2}));
  double meanA = 0, meanB = 0;
  for (std::size_t i = 0; i < a.values.size(); i += 2) meanA += static_cast<double>(a.values[i]) / (24 * 18);
  for (std::size_t i = 0; i < b.values.size(); i += 2) meanB += static_cast<double>(b.values[i]) / (7 * 5);
  EXPECT_NEAR(meanA, meanB, 1e-5);
}

TEST(Bake, ACancelledBakeLeavesTheOlderOneAlone) {
  const TemporaryFolder folder;
  mustBake(smallProject(), requestFor(folder.path(), {"npy", "png"}, {0, 10, 2, 0}));
  const std::string before = readFile(folder.path() / "manifest.json").value();
  const long entries = folder.entries();
  for (const BakePhase when : {BakePhase::Recording, BakePhase::Writing}) {
    const Result<BakeReport> report =
        bake(*simulate(smallProject()), requestFor(folder.path(), {"npy", "png"}, {0, 10, 9, 0}),
             [&](const BakeProgress& p) { return !(p.phase == when && p.part > 0.4); });
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->cancelled);
    EXPECT_EQ(readFile(folder.path() / "manifest.json").value(), before);
    EXPECT_EQ(folder.entries(), entries);
  }
}

TEST(Bake, RemovesWhatOnlyTheOlderBakeHad) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileAtomically(folder.path() / "notes.txt", "mine"));
  mustBake(smallProject(), requestFor(folder.path(), {"png"}, {0, 10, 5, 0}));
  EXPECT_TRUE(fs::exists(folder.path() / "flow.0004.png"));
  mustBake(smallProject(), requestFor(folder.path(), {"png"}, {0, 10, 3, 0}));
  EXPECT_TRUE(fs::exists(folder.path() / "flow.0002.png"));
  EXPECT_FALSE(fs::exists(folder.path() / "flow.0003.png"));
  EXPECT_TRUE(fs::exists(folder.path() / "notes.txt"));
}

TEST(Bake, LeavesAloneWhatWasChangedSinceTheOlderBake) {
  const TemporaryFolder folder;
  mustBake(smallProject(), requestFor(folder.path(), {"png"}, {0, 10, 3, 0}));
  ASSERT_TRUE(writeFileAtomically(folder.path() / "flow.0002.png", "painted over"));
  mustBake(smallProject(), requestFor(folder.path(), {"png"}, {0, 10, 1, 0}));
  EXPECT_FALSE(fs::exists(folder.path() / "flow.0001.png"));
  EXPECT_EQ(readFile(folder.path() / "flow.0002.png").value(), "painted over");
}

TEST(Bake, RefusesAFolderWithAnotherManifest) {
  const TemporaryFolder folder;
  for (const char* text : {"{}", "not JSON", "{\"format\": \"webapp\", \"files\": []}"}) {
    ASSERT_TRUE(writeFileAtomically(folder.path() / "manifest.json", text));
    const Result<BakeReport> report =
        bake(*simulate(smallProject()), requestFor(folder.path(), {"npy"}, {0, 10, 1, 0}), {});
    ASSERT_FALSE(report) << text;
    EXPECT_EQ(report.error().kind, ErrorKind::BadInput);
    EXPECT_NE(report.error().text().find("manifest.json"), std::string::npos);
    EXPECT_EQ(readFile(folder.path() / "manifest.json").value(), text);
    EXPECT_EQ(folder.entries(), 1);
  }
}

TEST(Bake, LeavesNoEmptyFolderWhenItEndsEarly) {
  const TemporaryFolder folder;
  const auto at = [&](const fs::path& path) {
    const Result<BakeReport> report = bake(*simulate(smallProject()), requestFor(path, {"npy"}, {0, 10, 9, 0}),
                                           [](const BakeProgress& p) { return p.part < 0.3; });
    return report && report->cancelled;
  };
  EXPECT_TRUE(at(folder.path() / "new" / "deeper"));
  EXPECT_EQ(folder.entries(), 0);
  fs::create_directory(folder.path() / "mine");
  EXPECT_TRUE(at(folder.path() / "mine" / "deeper"));
  EXPECT_TRUE(fs::exists(folder.path() / "mine")) << "what was there stays";
  EXPECT_FALSE(fs::exists(folder.path() / "mine" / "deeper"));
}

TEST(Bake, SaysWhereItCannotWrite) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileAtomically(folder.path() / "taken", "a file"));
  const Result<BakeReport> report =
      bake(*simulate(smallProject()), requestFor(folder.path() / "taken", {"npy"}, {0, 10, 1, 0}), {});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ErrorKind::Machine);
  EXPECT_NE(report.error().text().find("taken"), std::string::npos);
}

TEST(Bake, PartsInAnyOrderAreTheSameBytesAsTheWhole) {
  const TemporaryFolder whole, parted;
  BakeRequest request = requestFor(whole.path(), {"png"}, {0.1, 20, 8, 2});
  request.loop = request.response = request.sidecars = request.graph = true;
  request.fullScale = 6.0f;
  const BakeReport complete = mustBake(smallProject(), request);
  request.folder = parted.path();
  for (const auto& [first, last] : {std::pair(5, 7), {0, 1}, {2, 5}}) {
    EXPECT_FALSE(fs::exists(parted.path() / "manifest.json"));
    request.part = {first, last};
    EXPECT_EQ(mustBake(smallProject(), request).complete, first == 2);
  }
  EXPECT_EQ(complete.files.size(), 5 * 8 + 4u) << "five tracks; graph, snippet, how-to, manifest";
  EXPECT_EQ(parted.entries(), static_cast<long>(complete.files.size())) << "no part is left lying about";
  for (const std::string& name : complete.files)
    EXPECT_EQ(readFile(parted.path() / name).value(), readFile(whole.path() / name).value()) << name;
}

TEST(Bake, APartLeavesAnOlderBakeAloneUntilAllPartsAreThere) {
  const TemporaryFolder folder;
  BakeRequest request = requestFor(folder.path(), {"png"}, {0, 10, 4, 0});
  request.fullScale = 6.0f;
  mustBake(smallProject(), request);
  const std::string before = readFile(folder.path() / "flow.0000.png").value();
  request.plan.from = 0.5;
  request.part = {0, 1};
  mustBake(smallProject(), request);
  EXPECT_EQ(readFile(folder.path() / "flow.0000.png").value(), before);
  request.part = {2, 3};
  EXPECT_TRUE(mustBake(smallProject(), request).complete);
  EXPECT_NE(readFile(folder.path() / "flow.0000.png").value(), before);
  EXPECT_EQ(folder.entries(), 5);
}

TEST(Bake, PartsOfAnotherPlanDoNotMix) {
  const TemporaryFolder folder;
  BakeRequest request = requestFor(folder.path(), {"png"}, {0, 10, 4, 0});
  request.fullScale = 6.0f;
  request.part = {0, 1};
  EXPECT_FALSE(mustBake(smallProject(), request).complete);
  request.part = {2, 3};
  request.fullScale = 7.0f;
  EXPECT_FALSE(mustBake(smallProject(), request).complete);
  request.fullScale = 6.0f;
  EXPECT_TRUE(mustBake(smallProject(), request).complete);
}

TEST(Bake, ARangeOfACompleteBakeIsPutBack) {
  const TemporaryFolder folder;
  BakeRequest request = requestFor(folder.path(), {"png"}, {0, 10, 4, 0});
  request.fullScale = 6.0f;
  mustBake(smallProject(), request);
  const std::string lost = readFile(folder.path() / "flow.0002.png").value();
  fs::remove(folder.path() / "flow.0002.png");
  request.part = {2, 2};
  EXPECT_TRUE(mustBake(smallProject(), request).complete);
  EXPECT_EQ(readFile(folder.path() / "flow.0002.png").value(), lost);
  EXPECT_EQ(folder.entries(), 5);
}

TEST(Bake, PartsThatBeganOtherwiseDoNotMix) {
  const TemporaryFolder folder;
  BakeRequest request = requestFor(folder.path(), {"png"}, {1, 10, 4, 0});
  request.fullScale = 6.0f;
  request.part = {0, 1};
  EXPECT_FALSE(mustBake(smallProject(), request).complete);
  request.part = {2, 3};
  const auto late = simulate(smallProject());
  late->startAt(0.5);
  const Result<BakeReport> report = bake(*late, request, {});
  ASSERT_TRUE(report);
  EXPECT_FALSE(report->complete) << "another warm-up is another recording";
  EXPECT_EQ(report->missing, (std::vector<std::pair<int, int>>{{0, 1}}));
}

TEST(Bake, AFolderInTheWayLeavesTheOlderBakeWhole) {
  const TemporaryFolder folder;
  mustBake(smallProject(), requestFor(folder.path(), {"png"}, {0, 10, 2, 0}));
  const std::string frame = readFile(folder.path() / "flow.0000.png").value();
  const std::string manifest = readFile(folder.path() / "manifest.json").value();
  fs::create_directory(folder.path() / "flow.0002.png");
  const Result<BakeReport> report =
      bake(*simulate(smallProject()), requestFor(folder.path(), {"png"}, {0.5, 10, 3, 0}), {});
  ASSERT_FALSE(report);
  EXPECT_NE(report.error().text().find("flow.0002.png"), std::string::npos);
  EXPECT_EQ(readFile(folder.path() / "flow.0000.png").value(), frame);
  EXPECT_EQ(readFile(folder.path() / "manifest.json").value(), manifest);
}

TEST(Bake, WaitsForAnotherOneInTheFolderAndCanBeCancelledMeanwhile) {
  const TemporaryFolder folder;
  const Result<FolderLock> other = FolderLock::take(folder.path(), [] { return false; });
  ASSERT_TRUE(other && other->held());
  int asked = 0;
  const Result<BakeReport> report =
      bake(*simulate(smallProject()), requestFor(folder.path(), {"npy"}, {0, 10, 1, 0}),
           [&](const BakeProgress& p) { return p.phase == BakePhase::Recording || ++asked < 3; });
  ASSERT_TRUE(report);
  EXPECT_TRUE(report->cancelled);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(Bake, RefusesPartsThatCannotBeTheSameAsTheWhole) {
  const TemporaryFolder folder;
  const auto refusal = [&](std::initializer_list<const char*> formats, std::pair<int, int> part, bool scale) {
    BakeRequest request = requestFor(folder.path(), formats, {0, 10, 4, 0});
    request.part = part;
    if (scale) request.fullScale = 6.0f;
    const Result<BakeReport> report = bake(*simulate(smallProject()), request, {});
    if (report) return std::string("accepted");
    EXPECT_EQ(report.error().kind, ErrorKind::Usage);
    return report.error().text();
  };
  EXPECT_NE(refusal({"npy"}, {0, 1}, true).find("npy"), std::string::npos);
  EXPECT_NE(refusal({"png"}, {0, 1}, false).find("--vmax"), std::string::npos);
  EXPECT_NE(refusal({"png"}, {2, 4}, true).find("0 to 3"), std::string::npos);
  EXPECT_EQ(refusal({"png"}, {2, 3}, true), "accepted");
}

TEST(Bake, TellsHowSmoothlyALoopRepeats) {
  const TemporaryFolder folder;
  BakeRequest request = requestFor(folder.path(), {"npy"}, {0.0, 20, 8, 2});
  request.loop = true;
  const BakeReport report = mustBake(smallProject(), request);
  const NpyArray wind = readWind(folder.path());
  const std::size_t size = wind.values.size() / 8;
  std::vector<std::vector<glm::vec2>> frames(8);
  for (std::size_t i = 0; i < wind.values.size(); i += 2)
    frames[i / size].emplace_back(wind.values[i], wind.values[i + 1]);
  float step = 0;
  for (std::size_t n = 1; n < 8; ++n) step = std::max(step, largestChange(frames[n - 1], frames[n]));
  EXPECT_FLOAT_EQ(report.seam.seam, largestChange(frames[7], frames[0]));
  EXPECT_FLOAT_EQ(report.seam.step, step);
  EXPECT_LT(report.seam.seam, report.seam.step);
  EXPECT_NEAR(readManifest(folder.path())["time"]["seam"]["change"].get<float>(), report.seam.seam, 1e-6f);
}

TEST(Bake, TheResponseRestsWhereTheWindIsSteady) {
  Project still = smallProject();
  still.graph = std::make_shared<WindGraph>();
  const TemporaryFolder folder;
  BakeRequest request = requestFor(folder.path(), {"npy"}, {0.0, 20, 5, 0});
  request.response = true;
  const BakeReport report = mustBake(still, request);
  EXPECT_EQ(report.files.size(), 6u);
  float last = 10;
  for (const PlantClass& plant : plantClasses()) {
    const NpyArray bend = readNpy(folder.path() / (std::string(plant.name) + "-wind.npy")).value();
    EXPECT_NEAR(bend.values.front(), bend.values[bend.values.size() - 2], 1e-4f) << plant.name;
    EXPECT_GT(bend.values.front(), 0.0f);
    EXPECT_LT(bend.values.front(), last) << "from soft to stiff";
    last = bend.values.front();
  }
  EXPECT_EQ(readManifest(folder.path())["response"]["classes"].size(), 4u);
}

TEST(Bake, StandsInItsPresetsShaderCode) {
  const TemporaryFolder folder;
  BakeRequest request = requestFor(folder.path(), {"png"}, {0, 10, 2, 0});
  request.sidecars = true;
  request.fullScale = 7.5f;
  const auto snippetOf = [&](Preset preset, const char* name) {
    request.preset = preset;
    mustBake(smallProject(), request);
    EXPECT_TRUE(fs::exists(folder.path() / "HOWTO.md"));
    return readFile(folder.path() / name).value();
  };
  EXPECT_NE(snippetOf(Preset::Generic, "wind.glsl").find("vec2 WIND_MIN = vec2(-2.0, -9.0)"), std::string::npos);
  EXPECT_NE(snippetOf(Preset::Unreal, "wind.hlsl").find("float2 WIND_SIZE = float2(2400.0, 1800.0)"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(folder.path() / "wind.glsl")) << "the older bake's files are gone";
  EXPECT_NE(snippetOf(Preset::Unity, "wind.hlsl").find("WIND_MIN = float2(-22.0, -9.0)"), std::string::npos);
  EXPECT_NE(snippetOf(Preset::Godot, "wind.gdshaderinc").find("WIND_FULL_SCALE = 7.5"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder.path() / "flow.0001.png.import"));
}

TEST(InitialField, IsTheFirstFrameOfABakeAndAnEarlierBakeGoesOn) {
  const TemporaryFolder folder;
  std::vector<float> values(18 * 24 * 2);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.5f * static_cast<float>(i % 2);
  ASSERT_TRUE(writeNpy(folder.path() / "start.npy", {18, 24, 2}, values));
  const auto simulation = simulate(smallProject());
  const Status loaded = loadInitialField(*simulation, folder.path() / "start.npy");
  ASSERT_TRUE(loaded) << loaded.error().text();
  for (const glm::vec2 v : simulation->velocity()) {
    EXPECT_NEAR(v.x, 0.0f, 1e-5f);
    EXPECT_NEAR(v.y, 0.5f, 1e-5f);
  }
  values.resize(2 * values.size(), 0.25f);
  ASSERT_TRUE(writeNpy(folder.path() / "bake.npy", {2, 18, 24, 2}, values));
  ASSERT_TRUE(loadInitialField(*simulation, folder.path() / "bake.npy"));
  for (const glm::vec2 v : simulation->velocity()) EXPECT_NEAR(v.x, 0.25f, 1e-5f);
}

TEST(InitialField, RefusesOtherShapesAndValues) {
  const TemporaryFolder folder;
  const auto simulation = simulate(smallProject());
  const auto refusal = [&](const std::vector<std::size_t>& shape, std::vector<float> values) {
    EXPECT_TRUE(writeNpy(folder.path() / "start.npy", shape, values));
    const Status status = loadInitialField(*simulation, folder.path() / "start.npy");
    if (status) return std::string("accepted");
    EXPECT_EQ(status.error().kind, ErrorKind::BadInput);
    return status.error().text();
  };
  EXPECT_NE(refusal({18, 24}, std::vector<float>(18 * 24)).find("wrong shape"), std::string::npos);
  EXPECT_NE(refusal({18, 24, 3}, std::vector<float>(18 * 24 * 3)).find("wrong shape"), std::string::npos);
  EXPECT_NE(refusal({24, 18, 2}, std::vector<float>(18 * 24 * 2)).find("18 x 24"), std::string::npos);
  EXPECT_NE(refusal({24, 18, 2}, std::vector<float>(18 * 24 * 2)).find("start.npy"), std::string::npos);
}

}  // namespace windloom
