// What a frame of a bake takes to tell how plants lean.
#include <benchmark/benchmark.h>

#include <vector>

#include "engine/bake/response.hpp"

namespace windloom {
namespace {

/// On a square of so many cells, all four classes, on all cores.
void PlantResponseFrame(benchmark::State& state) {
  const std::size_t cells = static_cast<std::size_t>(state.range(0)) * static_cast<std::size_t>(state.range(0));
  std::vector<glm::vec2> wind(cells, {3, 1});
  PlantResponse response(cells);
  response.advance(wind, 0);
  for (auto _ : state) {
    wind[0].x += 1;
    response.advance(wind, 1.0 / 30);
  }
}
BENCHMARK(PlantResponseFrame)->Arg(256)->Arg(1024)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace windloom

BENCHMARK_MAIN();
