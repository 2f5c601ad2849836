#include "engine/cli/bench_frames.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <map>

#include "engine/cli/bench_timing.hpp"
#include "engine/cli/draw_work.hpp"
#include "engine/gpu/memory.hpp"

namespace windloom::cli {
namespace {

// So many frames follow each other without a wait, so that the GPU doesn't idle between them...
constexpr int kMostFrames = 20;
// ...but no more than take this long together, ms.
constexpr double kBatchMs = 300;
// A GPU that idled is slow for a while, ms.
constexpr double kWarmUpMs = 400;

/// One run: what changes from frame to frame and what was measured of it.
struct Run {
  FrameRenderer& renderer;
  Simulation* simulation;
  FrameInput input;
  gpu::GpuTimer windTimer;
  FrameStats stats;
  std::vector<double> wind;
  std::map<std::string, std::vector<double>> stages;

  void frame() {
    if (simulation != nullptr) {
      windTimer.beginFrame();
      windTimer.stage("wind");
      simulation->step();
      windTimer.endFrame();
      input.wind = {simulation->solver().velocityTexture(), simulation->solver().grid()};
      input.time = simulation->time();
    }
    stats = renderer.render(input);
    if (const double ms = windTimer.totalMs(); simulation != nullptr && ms > 0) wind.push_back(ms);
    for (const auto& [stage, ms] : stats.passMs) stages[stage].push_back(ms);
  }
  void forget() {
    wind.clear();
    stages.clear();
  }
};

FrameTimes summary(const Run& run) {
  FrameTimes times;
  if (!run.wind.empty()) times.windMs = median(run.wind);
  for (const auto& [stage, values] : run.stages) {
    const double ms = median(values);
    times.stages[stage] = ms;
    (stage.starts_with("grass ") ? times.grassMs : times.drawingMs) += ms;
  }
  times.drawn = run.stats.bladesDrawn;
  times.bezier = run.stats.bezier;
  times.shell = run.stats.shell;
  times.shapeBytes = gpu::bytesInUse("bezier blades");
  times.stateBytes = gpu::bytesInUse("bezier states");
  times.shellBytes = gpu::bytesInUse("shell");
  times.grassBytes = gpu::bytesInUse("grass");
  times.allBytes = gpu::bytesInUse();
  return times;
}

}  // namespace

Result<FrameBench> FrameBench::create(const BenchSetup& setup, glm::ivec2 size) {
  FrameBench bench(setup);
  Result<std::unique_ptr<FrameRenderer>> renderer = FrameRenderer::create(*setup.context, *setup.shaders);
  if (!renderer) return renderer.error();
  Result<gpu::Framebuffer> target = benchTarget(size);
  if (!target) return target.error();
  bench.m_renderer = std::move(*renderer);
  bench.m_target = std::move(*target);
  return bench;
}

Result<FrameTimes> FrameBench::run(const Project& project, Simulation* simulation, const ViewCamera& camera,
                                   const FrameQuality& quality, const BezierCulling& culling) {
  Run run{*m_renderer, simulation, benchFrame(project, m_wind, camera, m_target), gpu::GpuTimer(), {}, {}, {}};
  run.input.time = m_time;
  run.input.quality = quality;
  run.input.bezierCulling = culling;
  m_target.clearColour({1.0f, 0.0f, 1.0f, 0.0f});
  run.frame();
  // The renderer gives every pixel alpha 1.
  if (m_target.readRgba8()[3] == 0) return makeError(ErrorKind::Machine, "not drawn: no memory");
  const double oneMs = gpuMs([&] { run.frame(); });
  const bool patient = !m_setup->context->info().software && m_setup->size == BenchSize::Full;
  for (double spent = 0; patient && spent < kWarmUpMs;) {
    spent += wallMs([&] {
      run.frame();
      glFinish();
    });
  }
  const int batch = patient ? std::clamp(static_cast<int>(kBatchMs / std::max(oneMs, 0.01)), 1, kMostFrames) : 1;
  std::vector<double> wall;
  run.forget();
  const Measured frames = measure({1, 3, 10, 0.5 * m_setup->capSeconds}, [&] {
    double ms = 0;
    const auto work = [&] {
      for (int i = 0; i < batch; ++i) run.frame();
    };
    wall.push_back(wallMs([&] { ms = gpuMs(work); }) / batch);
    return ms / batch;
  });
  FrameTimes times = summary(run);
  times.frameMs = frames.median;
  times.wallMs = median(wall);
  times.frames = frames.runs * batch;
  if (m_counts) {
    const DrawWork work = drawWork([&] { run.frame(); });
    times.triangles = work.triangles;
    times.fragments = work.fragments;
  }
  return times;
}

void FrameBench::hold(const WindTexture& wind, double time) {
  m_wind = wind;
  m_time = time;
}

Result<std::unique_ptr<Simulation>> benchWind(const BenchSetup& setup, const Project& project) {
  SimulationOptions options;
  options.backend = Backend::Gpu;
  options.context = setup.context;
  options.shaders = setup.shaders;
  return Simulation::create(project, options);
}

glm::ivec2 benchPictureSize(const BenchSetup& setup) {
  return setup.picture.value_or(setup.size == BenchSize::Quick ? glm::ivec2(160, 90) : glm::ivec2(1920, 1080));
}

}  // namespace windloom::cli
