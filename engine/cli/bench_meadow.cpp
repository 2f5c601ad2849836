// The table of Choi & Sung, "CWD-Sim", 2024: what a frame costs by the number of blades, with the wind solved on
// 1000 x 1000 cells; and what it costs without thinning and culling.
#include "engine/cli/bench_frames.hpp"
#include "engine/cli/bench_project.hpp"

namespace windloom::cli {
namespace {

constexpr double kMiB = 1 << 20;

struct Mode {
  const char* name;
  FrameQuality quality;
};
constexpr Mode kModes[] = {
    {"all", {}},
    {"no thinning", {.thinning = false}},
    {"no culling", {.culling = false}},
    {"neither", {.thinning = false, .culling = false}},
};

struct MeadowBench {
  const BenchSetup& setup;
  std::vector<BenchRow> rows;

  /// One meadow in the first `modes` of kModes, each seen from every camera named.
  Status add(const BenchMeadow& meadow, std::span<const Mode> modes, std::string_view onlyCamera) {
    const bool quick = setup.size == BenchSize::Quick;
    const Project project = benchWindyMeadow(meadow.metres, meadow.density, quick ? 64 : 1000);
    const Result<std::unique_ptr<Simulation>> simulation = benchWind(setup, project);
    if (!simulation) return simulation.error();
    for (const Mode& mode : modes) {
      // A new renderer: lists only grow, and memory is told for each meadow.
      Result<FrameBench> frames = FrameBench::create(setup, benchPictureSize(setup));
      if (!frames) return frames.error();
      for (const BenchShot& shot : benchShots(meadow.metres)) {
        if (onlyCamera.empty() || onlyCamera == shot.name) addRow(*frames, meadow, mode, shot, project, **simulation);
      }
    }
    return Done{};
  }

  void addRow(FrameBench& frames, const BenchMeadow& meadow, const Mode& mode, const BenchShot& shot,
              const Project& project, Simulation& simulation) {
    BenchRow row = {{"blades", meadow.name}, {"camera", shot.name}, {"with", mode.name}};
    if (const Result<FrameTimes> times = frames.run(project, &simulation, shot.camera, mode.quality)) {
      row.update({{"wind sim ms", times->windMs},
                  {"grass sim ms", times->grassMs},
                  {"shadow ms", 0},  // taken from the blade's height while it is drawn
                  {"rendering ms", times->drawingMs},
                  {"frame ms", times->frameMs},
                  {"fps", 1000 / times->wallMs},
                  {"drawn", times->drawn},
                  {"grass MiB", static_cast<double>(times->grassBytes) / kMiB},
                  {"all MiB", static_cast<double>(times->allBytes) / kMiB},
                  {"runs", times->frames},
                  {"stages", times->stages}});
    } else {
      row["note"] = times.error().text();
    }
    rows.push_back(std::move(row));
  }
};

/// Those of the paper on 100 m, then on 1 km, and last as many on 100 m.
std::vector<BenchMeadow> meadowsOf(const BenchSetup& setup) {
  if (setup.size == BenchSize::Quick) return {{"2 k", 10, 20}};
  std::vector<BenchMeadow> meadows;
  // On a software renderer more take minutes and say nothing.
  const std::vector<int> own =
      setup.context->info().software ? std::vector{1, 7} : std::vector{1, 2, 3, 4, 5, 6, 7, 20, 50, 100};
  for (const int millions : setup.blades.empty() ? own : setup.blades) meadows.push_back(benchMeadowOf(millions));
  if (setup.blades.empty() && !setup.context->info().software) meadows.push_back({"100 M on 100 m", 100, 10'000});
  return meadows;
}

}  // namespace

Result<std::vector<BenchRow>> benchMeadowTable(const BenchSetup& setup) {
  if (setup.context == nullptr) return std::vector<BenchRow>{};
  MeadowBench bench{setup, {}};
  const std::vector<BenchMeadow> meadows = meadowsOf(setup);
  for (const BenchMeadow& meadow : meadows) {
    if (Status added = bench.add(meadow, std::span(kModes).first(1), {}); !added) return added.error();
  }
  for (const BenchMeadow& meadow : meadows) {
    const bool between = &meadow != &meadows.front() && meadow.metres == 100 && meadow.density < 700;
    if (between) continue;
    if (Status added = bench.add(meadow, std::span(kModes).subspan(1), "eye"); !added) return added.error();
  }
  return std::move(bench.rows);
}

}  // namespace windloom::cli
