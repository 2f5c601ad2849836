// The table of Belyaev, Laevsky & Chukanov, "Real-Time Animation, Collision and Rendering of Grassland", 2011: a field
// of 280 m with a million blades, at rest, in wind, in wind and touched by rolling balls.
#include <cmath>
#include <numbers>

#include "engine/cli/bench_frames.hpp"
#include "engine/cli/bench_project.hpp"

namespace windloom::cli {
namespace {

constexpr float kMetres = 280;
constexpr float kBlades = 1e6f;
constexpr Id kFirstBallId = 100'000;  // after those of the wind's graph

struct Column {
  const char* name;
  bool wind;
  int balls;
};
constexpr Column kColumns[] = {
    {"A no animation", false, 0}, {"B wind", true, 0}, {"C wind and a ball", true, 1}, {"wind and 20 balls", true, 20}};

/// A ball of 1 m that rolls in a circle of 5 m in 8 s, around `centre`.
Collider ballAround(glm::vec2 centre, Id id) {
  constexpr int kKeys = 32;
  Collider ball;
  ball.id = id;
  ball.position = centre;
  for (int i = 0; i <= kKeys; ++i) {
    const float part = static_cast<float>(i) / kKeys, angle = 2.0f * std::numbers::pi_v<float> * part;
    ball.keys.push_back({8.0f * part, 5.0f * glm::vec3(std::cos(angle), 0.0f, std::sin(angle))});
  }
  return ball;
}

/// In rows of five before the camera "eye", which sees the first from 10 m.
Shared<std::vector<Collider>> ballsOf(int count, float metres) {
  std::vector<Collider> balls;
  for (int i = 0; i < count; ++i) {
    const glm::vec2 place(12.0f * static_cast<float>((i % 5 + 1) / 2) * (i % 2 == 0 ? 1.0f : -1.0f),
                          0.4f * metres - 10.0f - 12.0f * static_cast<float>(i / 5));
    balls.push_back(ballAround(place, kFirstBallId + static_cast<Id>(i)));
  }
  return std::make_shared<std::vector<Collider>>(std::move(balls));
}

Project grassland(const BenchSetup& setup) {
  const bool quick = setup.size == BenchSize::Quick;
  const float metres = quick ? 20.0f : kMetres;
  Project project = benchWindyMeadow(metres, kBlades / (kMetres * kMetres), quick ? 64 : 1000);
  auto grass = std::make_shared<GrassSettings>(*project.grass);
  grass->deformation = Deformation::Inertial;
  project.grass = std::move(grass);
  return project;
}

BenchRow rowOf(const Column& column, const BenchShot& shot, const FrameTimes& times) {
  return {{"column", column.name},
          {"camera", shot.name},
          {"wind sim ms", times.windMs},
          {"grass sim ms", times.grassMs},
          {"rendering ms", times.drawingMs},
          {"frame ms", times.frameMs},
          {"fps", 1000 / times.wallMs},
          {"drawn", times.drawn},
          {"runs", times.frames},
          {"stages", times.stages}};
}

}  // namespace

Result<std::vector<BenchRow>> benchGrassland(const BenchSetup& setup) {
  if (setup.context == nullptr) return std::vector<BenchRow>{};
  const Project meadow = grassland(setup);
  const float metres = meadow.field->size.x;
  std::vector<BenchRow> rows;
  for (const Column& column : kColumns) {
    Project project = meadow;
    project.colliders = ballsOf(column.balls, metres);
    const Result<std::unique_ptr<Simulation>> wind = benchWind(setup, project);
    if (!wind) return wind.error();
    Result<FrameBench> frames = FrameBench::create(setup, benchPictureSize(setup));
    if (!frames) return frames.error();
    for (const BenchShot& shot : benchShots(metres)) {
      const Result<FrameTimes> times = frames->run(project, column.wind ? wind->get() : nullptr, shot.camera, {});
      if (!times) return times.error();
      rows.push_back(rowOf(column, shot, *times));
    }
  }
  return rows;
}

}  // namespace windloom::cli
