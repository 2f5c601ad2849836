// What grass that remembers costs in a frame: a step of the virtual blades, one of patches around moving balls, and one
// of Bezier blades.
#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <cmath>

#include "engine/gpu/context.hpp"
#include "engine/grass/grass_patches.hpp"
#include "engine/grass/virtual_blades.hpp"
#include "tests/gpu/grass/bezier_blades.hpp"
#include "tests/gpu/grass/grass_scene.hpp"

namespace windloom {
namespace {

constexpr float kDt = 1.0f / 60.0f;

struct Machine {
  std::unique_ptr<gpu::Context> context = testing::taken(gpu::createOffscreenContext());
  std::unique_ptr<gpu::ShaderLibrary> shaders = testing::taken(gpu::ShaderLibrary::create());
};

Machine& machine() {
  static Machine found;
  return found;
}

void VirtualBladesStep(benchmark::State& state) {
  testing::GrassScene scene(*machine().shaders);
  const auto side = static_cast<int>(state.range(0));
  scene.field.resolution = {side, side};
  scene.blow({5.0f, 2.0f});
  VirtualBlades blades = testing::taken(VirtualBlades::create(*machine().shaders));
  if (!blades.configure(scene.grass, scene.field.resolution)) return state.SkipWithError("no memory");
  scene.bindFrame(0.0);
  for (auto _ : state) {
    blades.step({kDt, false});
    glFinish();
  }
}
BENCHMARK(VirtualBladesStep)->Arg(128)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Balls that roll side by side, as many as it takes to use all blades that may be remembered.
void PatchesStep(benchmark::State& state) {
  testing::GrassScene scene(*machine().shaders);
  scene.field.size = {100.0f, 100.0f};
  scene.grass.interacting = static_cast<int>(state.range(0));
  scene.blow({3.0f, 1.0f});
  VirtualBlades blades = testing::taken(VirtualBlades::create(*machine().shaders));
  GrassPatches patches = testing::taken(GrassPatches::create(*machine().shaders));
  const bool fits = patches.configure(scene.grass, scene.layout(), 0.75f).ok();
  if (!fits || !blades.configure(scene.grass, scene.field.resolution)) return state.SkipWithError("no memory");
  const int balls = 1 + static_cast<int>(state.range(0) / 10'000);
  std::vector<ColliderPrimitive> primitives(static_cast<std::size_t>(balls));
  const auto step = [&](int n) {
    for (int ball = 0; ball < balls; ++ball) {
      const float x = -20.0f + 0.025f * static_cast<float>(n % 1600), z = -30.0f + 5.0f * static_cast<float>(ball);
      primitives[static_cast<std::size_t>(ball)] = {glm::vec4(x, 0.4f, z, 0.4f), glm::vec4(x, 0.4f, z, 0.0f)};
    }
    patches.step({kDt, false}, primitives, nullptr);
  };
  scene.bindFrame(0.0);
  blades.bind();
  int n = 0;
  for (; n < 300; ++n) step(n);  // trails behind them
  for (auto _ : state) {
    step(n++);
    glFinish();
  }
  const auto remembered = patches.cells().patches().size() * static_cast<std::size_t>(patches.cells().stride());
  state.counters["blades"] = static_cast<double>(remembered);
}
BENCHMARK(PatchesStep)->Arg(1'000)->Arg(20'000)->Arg(100'000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Blades all seen, in patches of half a metre, with so many balls among them.
void BezierStep(benchmark::State& state) {
  testing::GrassScene scene(*machine().shaders);
  scene.grass.flutter = 0.35f;
  scene.blow({5.0f, 2.0f});
  const auto count = static_cast<std::size_t>(state.range(0));
  const auto row = static_cast<std::size_t>(std::sqrt(static_cast<double>(count) / BEZIER_PATCH));
  std::vector<testing::BladePlan> plans(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t patch = i / BEZIER_PATCH, own = i % BEZIER_PATCH;
    plans[i].root.x = 0.5f * static_cast<float>(patch % row) + static_cast<float>(own % 16) / 32.0f;
    plans[i].root.z = 0.5f * static_cast<float>(patch / row) + static_cast<float>(own / 16) / 32.0f;
  }
  const testing::BladeStore blades(plans);
  BezierPhysics physics = testing::taken(BezierPhysics::create(*machine().shaders));
  if (!physics.configure(blades.store())) return state.SkipWithError("no memory");
  Project project;
  std::vector<Collider> colliders(static_cast<std::size_t>(state.range(1)));
  for (std::size_t i = 0; i < colliders.size(); ++i) {
    const float way = 0.5f * static_cast<float>(row),
                z = way * (static_cast<float>(i) + 0.5f) / static_cast<float>(colliders.size());
    colliders[i].position = {0.0f, z};
    colliders[i].radius = 0.3f;
    colliders[i].keys = {{0.0f, {0, 0, 0}}, {10.0f, {way, 0, 0}}};
  }
  project.colliders = std::make_shared<std::vector<Collider>>(colliders);
  double time = 0.0;
  scene.bindFrame(time);
  physics.advance(project, blades.store(), time, false);
  glFinish();
  for (auto _ : state) {
    time += double{kDt};
    physics.advance(project, blades.store(), time, false);
    glFinish();
  }
}
BENCHMARK(BezierStep)
    ->Args({100'000, 0})
    ->Args({100'000, 20})
    ->Args({900'000, 0})
    ->Args({900'000, 200})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace windloom

BENCHMARK_MAIN();
