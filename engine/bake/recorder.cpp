#include "engine/bake/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/gpu/context.hpp"
#include "engine/session/frame_tap.hpp"

namespace windloom {

long stepOfFrame(const RecordPlan& plan, int n, double timeStep) {
  const double steps = (plan.from + n / plan.fps) / timeStep;
  // A time step is a float, so a whole number of them is off by up to 6e-8 of itself.
  const double noise = std::max(1e-6, steps * 2e-7);
  return std::max(0L, static_cast<long>(std::ceil(steps - noise)));
}

int crossfadeFor(int frames) {
  return frames < 2 ? 0 : std::max(1, frames / 4);
}

float seamWeight(const RecordPlan& plan, int n) {
  return n < plan.crossfade ? static_cast<float>(n) / static_cast<float>(plan.crossfade) : 1.0f;
}

namespace {

Error gpuLost() {
  return makeError(ErrorKind::Machine, std::string("recording stopped: ") + gpu::kGpuLost +
                                           ". Record again, or on the processor (--backend cpu).");
}

}  // namespace

Result<RecordEnd> record(Simulation& simulation, const RecordPlan& plan, const std::optional<glm::ivec2>& resolution,
                         const std::function<bool(int frame)>& wanted,
                         const std::function<Status(int frame, std::span<const glm::vec2> cells)>& take,
                         const std::function<bool(const RecordProgress&)>& keepGoing) {
  const auto timeStep = static_cast<double>(simulation.project().field->timeStep);
  int frames = plan.frames + plan.crossfade;
  while (frames > 0 && !wanted(frames - 1)) --frames;
  Result<std::unique_ptr<FrameTap>> made =
      makeFrameTap(simulation, resolution.value_or(simulation.solver().grid().resolution));
  if (!made) return made.error();
  FrameTap& tap = **made;
  // Hands on what has come; with Yes waits for one frame.
  const auto handOn = [&](FrameTap::Wait wait) -> Status {
    while (const auto frame = tap.take(wait)) {
      if (Status taken = take(frame->number, frame->cells); !taken) return taken;
      wait = FrameTap::Wait::No;
    }
    if (tap.lost()) return gpuLost();
    return Done{};
  };
  RecordProgress progress{simulation.steps(), stepOfFrame(plan, std::max(frames, 1) - 1, timeStep)};
  for (int frame = 0; frame < frames; ++frame) {
    if (!wanted(frame)) continue;
    for (const long until = stepOfFrame(plan, frame, timeStep); simulation.steps() < until; simulation.step()) {
      progress.step = simulation.steps();
      if (!keepGoing(progress)) return RecordEnd::Cancelled;
    }
    while (!tap.ask(frame)) {
      if (Status handed = handOn(FrameTap::Wait::Yes); !handed) return handed.error();
    }
    if (Status handed = handOn(FrameTap::Wait::No); !handed) return handed.error();
  }
  while (const auto frame = tap.take(FrameTap::Wait::Yes)) {
    if (Status taken = take(frame->number, frame->cells); !taken) return taken.error();
  }
  if (tap.lost()) return gpuLost();
  progress.step = progress.steps;
  keepGoing(progress);
  return RecordEnd::Finished;
}

}  // namespace windloom
