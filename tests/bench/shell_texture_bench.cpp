// What making a texture of shell grass costs, and choosing where shells stand.
#include <benchmark/benchmark.h>

#include "engine/grass/shell_placing.hpp"
#include "engine/grass/shell_texture.hpp"

namespace windloom {
namespace {

void MakeShellTexture(benchmark::State& state) {
  GrassSettings grass;
  ShellSettings shell;
  grass.density = static_cast<float>(state.range(0));
  shell.texels = static_cast<int>(state.range(1));
  std::size_t bytes = 0;
  for (auto _ : state) {
    const ShellTexture texture = makeShellTexture(grass, shell, {});
    bytes = 0;
    for (const ShellLevel& level : texture.levels) bytes += sizeof(glm::u8vec4) * 2 * level.form.size();
    state.counters["blades"] = static_cast<double>(texture.blades);
  }
  state.counters["MiB"] = static_cast<double>(bytes) / (1 << 20);
}
BENCHMARK(MakeShellTexture)->ArgsProduct({{100, 700, 5000}, {256, 1024}})->Unit(benchmark::kMillisecond);

void PlaceShells(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(placeShells(SHELL_SEGMENTS, static_cast<int>(state.range(0)), 1.0f, 1.0f, {}));
  }
}
BENCHMARK(PlaceShells)->Arg(8)->Arg(64)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace windloom

BENCHMARK_MAIN();
