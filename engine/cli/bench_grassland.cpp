// The table of Belyaev, Laevsky & Chukanov, "Real-Time Animation, Collision and Rendering of Grassland", 2011: a field
// of 280 m with a million blades, at rest, in wind.
#include "engine/cli/bench_frames.hpp"
#include "engine/cli/bench_project.hpp"

namespace windloom::cli {
namespace {

constexpr float kMetres = 280;
constexpr float kBlades = 1e6f;

struct Column {
  const char* name;
  bool wind;
};
constexpr Column kColumns[] = {{"A no animation", false}, {"B wind", true}};

Project grassland(const BenchSetup& setup) {
  const bool quick = setup.size == BenchSize::Quick;
  const float metres = quick ? 20.0f : kMetres;
  Project project = benchWindyMeadow(metres, kBlades / (kMetres * kMetres), quick ? 64 : 1000);
  auto grass = std::make_shared<GrassSettings>(*project.grass);
  grass->deformation = Deformation::Inertial;
  project.grass = std::move(grass);
  return project;
}

}  // namespace

Result<std::vector<BenchRow>> benchGrassland(const BenchSetup& setup) {
  if (setup.context == nullptr) return std::vector<BenchRow>{};
  Result<FrameBench> frames = FrameBench::create(setup, benchPictureSize(setup));
  if (!frames) return frames.error();
  const Project project = grassland(setup);
  const Result<std::unique_ptr<Simulation>> wind = benchWind(setup, project);
  if (!wind) return wind.error();
  std::vector<BenchRow> rows;
  for (const BenchShot& shot : benchShots(project.field->size.x)) {
    for (const Column& column : kColumns) {
      const Result<FrameTimes> times = frames->run(project, column.wind ? wind->get() : nullptr, shot.camera, {});
      if (!times) return times.error();
      rows.push_back({{"camera", shot.name},
                      {"column", column.name},
                      {"wind sim ms", times->windMs},
                      {"grass sim ms", times->grassMs},
                      {"rendering ms", times->drawingMs},
                      {"frame ms", times->frameMs},
                      {"fps", 1000 / times->wallMs},
                      {"drawn", times->drawn},
                      {"runs", times->frames},
                      {"stages", times->stages}});
    }
  }
  return rows;
}

}  // namespace windloom::cli
