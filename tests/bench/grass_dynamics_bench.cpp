// What grass that remembers costs in a frame: a step of the virtual blades, and one of patches around moving balls.
#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <cmath>

#include "engine/gpu/context.hpp"
#include "engine/grass/grass_patches.hpp"
#include "engine/grass/virtual_blades.hpp"
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

}  // namespace
}  // namespace windloom

BENCHMARK_MAIN();
