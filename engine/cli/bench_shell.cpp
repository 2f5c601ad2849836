// Table 2 of Bakay, Lalonde & Heidrich, "Real-time animated grass", 2002, for the sample prairie: what a frame costs by
// the number of shells and the size of the picture, near the worst case (grass fills the picture); the same for filled
// shells; and how near their pictures come to those of 65 plain ones.
#include <algorithm>
#include <iterator>

#include "engine/cli/bench_frames.hpp"
#include "engine/cli/bench_project.hpp"
#include "engine/render/framing.hpp"

namespace windloom::cli {
namespace {

constexpr glm::ivec2 kSizes[] = {{640, 480}, {1024, 768}, {1920, 1080}, {3840, 2160}};
// The paper's own; a frame of 65 plain shells takes a software renderer minutes at the others.
constexpr std::ptrdiff_t kSizesInSoftware = 2;
constexpr int kPaperWidth = 1024;  // wide at most
// Part of the time that a row may take: a software renderer would take as long for each of these many rows.
constexpr double kCapInSoftware = 0.25;
constexpr glm::ivec2 kComparedSize{1920, 1080}, kComparedSizeInSoftware{320, 180}, kQuickSize{128, 96};
// Over the ground, which the paper counts as one more.
constexpr int kPlainShells[] = {8, 16, 32, 64};
constexpr double kMoment = 8.0;  // s: the gust is in the middle of the prairie
constexpr glm::ivec2 kCellsInSoftware{140, 100}, kQuickCells{32, 32};
constexpr const char* kWorst = "worst";
constexpr int kPaperSamples = 1, kOwnSamples = 0;
// A sample's colour and depth, written once.
constexpr double kBytesASample = 8;

Project withKind(Project project, GrassKind kind) {
  GrassSettings grass = *project.grass;
  grass.kind = kind;
  project.grass = std::make_shared<GrassSettings>(grass);
  return project;
}

Project withPlain(Project project, int shells) {
  ShellSettings shell = *project.shell;
  shell.method = ShellMethod::Plain;
  shell.shells = shells;
  project.shell = std::make_shared<ShellSettings>(shell);
  return project;
}

/// What the grass adds to bare ground. Not its stages' times: a software renderer does their work later.
double grassMs(const FrameTimes& times, const FrameTimes& ground) {
  return times.frameMs - ground.frameMs;
}

std::string text(glm::ivec2 size) {
  return std::to_string(size.x) + " x " + std::to_string(size.y);
}

/// A sample in a wind that stands still at one moment, so that all frames of it have the same work.
struct Scene {
  std::string name;
  Project project;
  std::unique_ptr<Simulation> wind;

  [[nodiscard]] WindTexture texture() const { return {wind->solver().velocityTexture(), wind->solver().grid()}; }
};

Result<Scene> sceneOf(const BenchSetup& setup, const std::string& name) {
  const bool quick = setup.size == BenchSize::Quick;
  Result<Project> project = benchSample(name);
  if (!project) return project.error();
  if (quick || setup.context->info().software) {
    FieldSettings field = *project->field;
    field.resolution = quick ? kQuickCells : kCellsInSoftware;
    project->field = std::make_shared<FieldSettings>(field);
  }
  if (quick) {
    ShellSettings shell = *project->shell;
    shell.texels = 256;
    project->shell = std::make_shared<ShellSettings>(shell);
  }
  Result<std::unique_ptr<Simulation>> wind = benchWind(setup, *project);
  if (!wind) return wind.error();
  (*wind)->runTo(quick ? 0.1 : kMoment);
  return Scene{name, std::move(*project), std::move(*wind)};
}

struct ShellBench {
  const BenchSetup& setup;
  std::vector<BenchRow> rows;

  Result<FrameTimes> measured(FrameBench& frames, const Scene& scene, const Project& project, const Camera& camera,
                              const FrameQuality& quality) const {
    frames.hold(scene.texture(), scene.wind->time());
    frames.countWork();
    return frames.run(project, nullptr, viewThrough(camera), quality);
  }

  void addRow(const std::string& shells, glm::ivec2 size, int samples, const FrameTimes& times,
              const FrameTimes& ground) {
    const double pixels = static_cast<double>(size.x) * static_cast<double>(size.y);
    BenchRow row = {{"what", "table"},
                    {"camera", std::string("prairie ") + kWorst},
                    {"size", text(size)},
                    {"samples", samples == kOwnSamples ? Json("own") : Json(samples)},
                    {"shells", shells},
                    {"frame ms", times.frameMs},
                    {"fps", 1000.0 / std::max(times.frameMs, 1e-6)},
                    {"grass ms", grassMs(times, ground)},
                    {"triangles", std::max(times.triangles - ground.triangles, 0LL)},
                    {"layers", times.shell.layers},
                    {"fragments a pixel", static_cast<double>(times.fragments) / pixels},
                    {"textures MB", static_cast<double>(times.shellBytes) / 1e6},
                    {"runs", times.frames}};
    if (samples > 0) row["floor: MB moved"] = kBytesASample * pixels * samples / 1e6 + row["textures MB"].get<double>();
    row["stages"] = times.stages;
    rows.push_back(std::move(row));
  }

  /// All numbers of shells at one size of the picture.
  Status addTable(const Scene& prairie, const Camera& camera, glm::ivec2 size, int samples) {
    Result<FrameBench> frames = FrameBench::create(setup, size);
    if (!frames) return frames.error();
    const Result<FrameTimes> ground =
        measured(*frames, prairie, withKind(prairie.project, GrassKind::None), camera, {.samples = samples});
    if (!ground) return ground.error();
    addRow("1 (ground)", size, samples, *ground, *ground);
    for (const int shells : kPlainShells) {
      const Result<FrameTimes> times =
          measured(*frames, prairie, withPlain(prairie.project, shells), camera, {.samples = samples});
      if (!times) return times.error();
      addRow(std::to_string(shells + 1) + " plain", size, samples, *times, *ground);
    }
    const Result<FrameTimes> ours = measured(*frames, prairie, prairie.project, camera, {.samples = samples});
    if (!ours) return ours.error();
    addRow(std::to_string(prairie.project.shell->shells + 1) + " filled", size, samples, *ours, *ground);
    return Done{};
  }

  /// Filled shells against 65 plain ones, at as many samples as the renderer takes by itself.
  Status addCompared(const Scene& scene, const Camera& camera, glm::ivec2 size) {
    Result<FrameBench> frames = FrameBench::create(setup, size);
    if (!frames) return frames.error();
    const Result<FrameTimes> ground =
        measured(*frames, scene, withKind(scene.project, GrassKind::None), camera, {.samples = kOwnSamples});
    if (!ground) return ground.error();
    const Result<FrameTimes> plain =
        measured(*frames, scene, withPlain(scene.project, kPlainShells[3]), camera, {.samples = kOwnSamples});
    if (!plain) return plain.error();
    const FloatImage expected = halfLuma(frames->picture());
    for (const bool same : {true, false}) {
      const Result<FrameTimes> ours =
          measured(*frames, scene, scene.project, camera, {.thinning = !same, .samples = kOwnSamples});
      if (!ours) return ours.error();
      addComparison(scene, camera, size, same, *ours, *plain, *ground, halfLuma(frames->picture()), expected);
    }
    return Done{};
  }

  /// `same`: it looked only where the plain shells are, not closer, and didn't turn into the ground far away.
  void addComparison(const Scene& scene, const Camera& camera, glm::ivec2 size, bool same, const FrameTimes& ours,
                     const FrameTimes& plain, const FrameTimes& ground, const FloatImage& seen,
                     const FloatImage& expected) {
    const double ourMs = grassMs(ours, ground), plainMs = grassMs(plain, ground);
    rows.push_back({{"what", "compared"},
                    {"camera", scene.name + " " + camera.name},
                    {"size", text(size)},
                    {"samples", "own"},
                    {"shells", std::to_string(scene.project.shell->shells + 1) + (same ? " filled as 65" : " filled")},
                    {"frame ms", ours.frameMs},
                    {"grass ms", ourMs},
                    {"65 plain: frame ms", plain.frameMs},
                    {"65 plain: grass ms", plainMs},
                    {"cost, frame", ours.frameMs / std::max(plain.frameMs, 1e-6)},
                    {"cost, grass", ourMs / std::max(plainMs, 1e-6)},
                    {"SSIM", meanSsim(seen, expected)},
                    {"brightness %", 100 * meanOf(seen) / meanOf(expected)},
                    {"layers", ours.shell.layers},
                    {"textures MB", static_cast<double>(ours.shellBytes) / 1e6},
                    {"runs", ours.frames}});
  }

  [[nodiscard]] glm::ivec2 comparedSize() const {
    const glm::ivec2 own = setup.size == BenchSize::Quick   ? kQuickSize
                           : setup.context->info().software ? kComparedSizeInSoftware
                                                            : kComparedSize;
    const glm::ivec2 size = setup.picture.value_or(own);
    return glm::max(size - size % 2, glm::ivec2(32));  // halved to compare
  }
};

std::vector<glm::ivec2> tableSizes(const BenchSetup& setup) {
  if (setup.picture) return {*setup.picture};
  if (setup.size == BenchSize::Quick) return {kQuickSize};
  const std::ptrdiff_t count = setup.context->info().software ? kSizesInSoftware : std::ssize(kSizes);
  return {std::begin(kSizes), std::begin(kSizes) + count};
}

}  // namespace

Result<std::vector<BenchRow>> benchShell(const BenchSetup& asked) {
  if (asked.context == nullptr) return std::vector<BenchRow>{};
  BenchSetup setup = asked;
  if (setup.context->info().software) setup.capSeconds *= kCapInSoftware;
  ShellBench bench{setup, {}};
  Result<Scene> prairie = sceneOf(setup, "prairie");
  if (!prairie) return prairie.error();
  const std::vector<Camera>& cameras = *prairie->project.cameras;
  const auto worst =
      std::find_if(cameras.begin(), cameras.end(), [](const Camera& camera) { return camera.name == kWorst; });
  if (worst == cameras.end()) return makeError(ErrorKind::BadInput, "the sample prairie has no camera 'worst'");
  const std::vector<glm::ivec2> sizes = tableSizes(setup);
  const glm::ivec2 compared = bench.comparedSize();
  for (const glm::ivec2 size : sizes) {
    if (Status added = bench.addTable(*prairie, *worst, size, kPaperSamples); !added) return added.error();
  }
  if (Status added = bench.addTable(*prairie, *worst, compared, kOwnSamples); !added) return added.error();
  for (const glm::ivec2 size : sizes) {
    if (size.x > kPaperWidth || setup.picture || setup.size == BenchSize::Quick) break;
    if (Status added = bench.addCompared(*prairie, *worst, size); !added) return added.error();
  }
  for (const Camera& camera : cameras) {
    if (setup.size == BenchSize::Quick && camera.name != cameras.front().name && camera.name != kWorst) continue;
    if (Status added = bench.addCompared(*prairie, camera, compared); !added) return added.error();
  }
  const Result<Scene> knoll = sceneOf(setup, "knoll");
  if (!knoll) return knoll.error();
  if (Status added = bench.addCompared(*knoll, knoll->project.cameras->front(), compared); !added) return added.error();
  return std::move(bench.rows);
}

}  // namespace windloom::cli
