// What overlays cost: the marks of a large graph on the CPU, and a frame of the meadow with each overlay.
#include <benchmark/benchmark.h>
#include <epoxy/gl.h>

#include <cmath>

#include "engine/gpu/context.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/io/project_json.hpp"
#include "engine/render/framing.hpp"
#include "engine/render/overlay_marks.hpp"
#include "engine/session/session.hpp"

namespace windloom {
namespace {

constexpr int kTrees = 100, kArrowsPerTree = 100;

/// 10,000 arrows in 100 trees that each branch in two at every tenth point.
Shared<WindGraph> largeGraph(SignalKind kind) {
  WindGraph graph;
  Id id = 1;
  for (int tree = 0; tree < kTrees; ++tree) {
    const glm::vec2 root(8.0f * static_cast<float>(tree % 10), 8.0f * static_cast<float>(tree / 10));
    const std::size_t first = graph.points.size();
    for (int i = 0; i <= kArrowsPerTree; ++i) {
      const float turn = 0.3f * static_cast<float>(i);
      Point point;
      point.id = id++;
      point.position = root + 0.05f * static_cast<float>(i) * glm::vec2(std::cos(turn), std::sin(turn));
      graph.points.push_back(point);
    }
    for (int i = 1; i <= kArrowsPerTree; ++i) {
      Arrow arrow;
      arrow.id = id++;
      arrow.from = graph.points[first + static_cast<std::size_t>(i % 10 == 0 ? i / 2 : i - 1)].id;
      arrow.to = graph.points[first + static_cast<std::size_t>(i)].id;
      graph.arrows.push_back(arrow);
    }
    Signal signal;
    signal.root = graph.points[first].id;
    signal.kind = kind;
    graph.signals.push_back(signal);
  }
  return std::make_shared<WindGraph>(std::move(graph));
}

FrameInput inputOf(const Project& project, const GraphEvaluator& evaluator) {
  FrameInput input;
  input.project = &project;
  input.graph = &evaluator;
  return input;
}

/// One point moved each frame: a new graph pointer, everything made again.
void MarksWhileAPointIsDragged(benchmark::State& state) {
  Project projects[2];
  for (Project& project : projects) project.graph = largeGraph(SignalKind::Pulse);
  const GraphEvaluator evaluator(*projects[0].graph);
  MarkCache cache;
  std::size_t frame = 0;
  for (auto _ : state) {
    FrameInput input = inputOf(projects[frame++ % 2], evaluator);
    input.time = 1.0 + static_cast<double>(frame) / 60.0;
    benchmark::DoNotOptimize(cache.update(input));
  }
}
BENCHMARK(MarksWhileAPointIsDragged)->Unit(benchmark::kMillisecond);

void MarksWhileTimeRuns(benchmark::State& state) {
  Project project;
  project.graph = largeGraph(static_cast<SignalKind>(state.range(0)));
  const GraphEvaluator evaluator(*project.graph);
  MarkCache cache;
  FrameInput input = inputOf(project, evaluator);
  input.time = 100.0;
  for (auto _ : state) {
    input.time += 1.0 / 60.0;
    benchmark::DoNotOptimize(cache.update(input));
  }
}
BENCHMARK(MarksWhileTimeRuns)
    ->Unit(benchmark::kMillisecond)
    ->ArgName("signal")
    ->Arg(static_cast<int>(SignalKind::Constant))
    ->Arg(static_cast<int>(SignalKind::Pulse))
    ->Arg(static_cast<int>(SignalKind::Gusts));

/// A frame of the meadow in motion, 1280 x 720, grass at a detail that a software renderer holds; the wind itself
/// rests, so that only drawing is measured.
class Studio {
 public:
  static Studio& get() {
    static Studio studio;
    return studio;
  }
  void draw(const Overlays& overlays) {
    Session::View view;
    view.camera = frameField(*m_project.field);
    view.framebuffer = m_target.name();
    view.overlays = overlays;
    view.quality.detail = 0.3f;
    // A hair's breadth each frame, so that nothing kept from the last frame fits.
    view.camera.position.x += 1e-3f * static_cast<float>(m_frame++ % 100);
    m_session->draw(view);
    glFinish();
  }

 private:
  Studio() {
    m_context = gpu::createOffscreenContext().value();
    m_shaders = gpu::ShaderLibrary::create().value();
    m_project = loadProject(WINDLOOM_PROJECTS "/meadow/meadow.wind.json").value().project;
    FieldSettings field = *m_project.field;
    field.resolution = {384, 384};
    m_project.field = std::make_shared<FieldSettings>(field);
    m_target = gpu::Framebuffer::create("bench", {1280, 720}, {.colour = GL_RGBA8, .depth = 0}).value();
    SessionOptions options;
    options.context = m_context.get();
    options.shaders = m_shaders.get();
    options.liveGrid = LiveGrid::Full;
    m_session = Session::create(m_project, options).value();
    m_session->runTo(2.0);
  }
  std::unique_ptr<gpu::Context> m_context;
  std::unique_ptr<gpu::ShaderLibrary> m_shaders;
  Project m_project;
  gpu::Framebuffer m_target;
  std::unique_ptr<Session> m_session;
  int m_frame = 0;
};

void Frame(benchmark::State& state, const std::string& name) {
  const std::string names[] = {name};
  const Overlays overlays = overlaysByName(names).value();
  for (int i = 0; i < 3; ++i) Studio::get().draw(overlays);
  for (auto _ : state) Studio::get().draw(overlays);
}

}  // namespace
}  // namespace windloom

int main(int argc, char** argv) {
  for (const std::string name :
       {"none", "arrows", "vectors", "streamlines", "speed", "divergence", "vorticity", "lic"}) {
    benchmark::RegisterBenchmark(("Frame/" + name).c_str(),
                                 [name](benchmark::State& state) { windloom::Frame(state, name); })
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime()
        ->MeasureProcessCPUTime();
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
