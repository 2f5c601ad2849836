// How long the editor works on a graph of 10,000 arrows, without its window: loading, hovering, dragging one point,
// dragging everything, undo. What a frame adds for the wind and the picture: overlay_bench and `windloom bench solver`.

#include <benchmark/benchmark.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "editor/core/workspace.hpp"
#include "engine/core/file.hpp"
#include "engine/io/project_json.hpp"
#include "engine/session/simulation.hpp"

namespace windloom::editor {
namespace {

constexpr int kSide = 100;  // points along a side of the field; each but the first has one arrow to it

/// A tree that fills the field: a trunk along the low z side, branches from it along z, all a little crooked.
Project bigProject() {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> crooked(-0.3f, 0.3f);
  WindGraph graph;
  const auto idOf = [](int x, int z) { return static_cast<Id>(1 + z * kSide + x); };
  for (int z = 0; z < kSide; ++z) {
    for (int x = 0; x < kSide; ++x) {
      Point point;
      point.id = idOf(x, z);
      point.position = {static_cast<float>(x) - 49.5f + crooked(random),
                        static_cast<float>(z) - 49.5f + crooked(random)};
      graph.points.push_back(point);
      if (x == 0 && z == 0) continue;
      Arrow arrow;
      arrow.id = static_cast<Id>(kSide * kSide) + point.id;
      arrow.from = z > 0 ? idOf(x, z - 1) : idOf(x - 1, z);
      arrow.to = point.id;
      arrow.radius = 1;
      graph.arrows.push_back(arrow);
    }
  }
  Project project;
  project.graph = std::make_shared<WindGraph>(std::move(graph));
  return project;
}

/// A workspace that looks straight down on all of it, 10 pixels a metre.
struct Bench {
  Workspace w;
  Bench() {
    w.document.startNew(bigProject());
    w.viewportSize = {1000.0f, 1000.0f};
    w.camera = lookAlong(EditorCamera{}, ViewDirection::Top);
    w.camera.distance = 50.0f / std::tan(glm::radians(22.5f));
    w.activateTool("select");
  }
  [[nodiscard]] PointerEvent at(glm::vec2 ground) const {
    PointerEvent pointer;
    pointer.pixel = *w.view().groundToScreen(ground, w.ground);
    return pointer;
  }
  [[nodiscard]] glm::vec2 middlePoint() const {
    return findPoint(*w.document.project().graph, static_cast<Id>(kSide * kSide / 2 + kSide / 2))->position;
  }
};

void load(benchmark::State& state) {
  const auto path = std::filesystem::temp_directory_path() / "windloom-editor-bench.wind.json";
  if (!writeFileAtomically(path, writeProject(bigProject()))) return state.SkipWithError("can't write");
  for (auto _ : state) {
    Document document;
    if (!document.open(path)) return state.SkipWithError("can't load");
    benchmark::DoNotOptimize(document.project());
  }
  std::filesystem::remove(path);
}

void hover(benchmark::State& state) {
  Bench b;
  float x = -40;
  for (auto _ : state) {
    b.w.pointerMoved(b.at({x, 3.3f}));
    x = x > 40 ? -40 : x + 0.37f;
  }
}

/// A frame of a drag: the pointer moves, the wind takes the new graph.
void drag(benchmark::State& state, bool everything) {
  Bench b;
  auto made = Simulation::create(b.w.document.project(), {.backend = Backend::Cpu, .resolution = glm::ivec2(64)});
  if (!made) return state.SkipWithError("no simulation");
  const std::unique_ptr<Simulation> simulation = std::move(*made);
  if (everything) b.w.actions.run("select.all");
  const glm::vec2 from = b.middlePoint();
  b.w.pointerMoved(b.at(from));
  b.w.pointerPressed(b.at(from));
  b.w.pointerMoved(b.at(from + glm::vec2(0.5f, 0)));
  float x = 0.5f;
  for (auto _ : state) {
    x = x > 3 ? 0.5f : x + 0.1f;
    b.w.pointerMoved(b.at(from + glm::vec2(x, 0.2f)));
    if (!simulation->setProject(b.w.document.project())) return state.SkipWithError("refused");
  }
  if (!b.w.document.previewing()) state.SkipWithError("nothing was dragged");
}

void dragPoint(benchmark::State& state) {
  drag(state, false);
}
void dragAll(benchmark::State& state) {
  drag(state, true);
}

void undoRedo(benchmark::State& state) {
  Bench b;
  b.w.actions.run("select.all");
  if (!b.w.apply(moveEdit(b.w.document.project(), b.w.selection.ids(), {1, 0}))) return state.SkipWithError("refused");
  for (auto _ : state) {
    b.w.undo();
    b.w.redo();
  }
}

BENCHMARK(load)->Unit(benchmark::kMillisecond);
BENCHMARK(hover)->Unit(benchmark::kMillisecond);
BENCHMARK(dragPoint)->Unit(benchmark::kMillisecond);
BENCHMARK(dragAll)->Unit(benchmark::kMillisecond);
BENCHMARK(undoRedo)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace windloom::editor

BENCHMARK_MAIN();
