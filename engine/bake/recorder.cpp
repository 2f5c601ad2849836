#include "engine/bake/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/bake/resample.hpp"

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

Result<RecordEnd> record(Simulation& simulation, const RecordPlan& plan, const std::optional<glm::ivec2>& resolution,
                         const std::function<bool(int frame)>& wanted,
                         const std::function<Status(int frame, std::span<const glm::vec2> cells)>& take,
                         const std::function<bool(const RecordProgress&)>& keepGoing) {
  const auto timeStep = static_cast<double>(simulation.project().field->timeStep);
  int frames = plan.frames + plan.crossfade;
  while (frames > 0 && !wanted(frames - 1)) --frames;
  const glm::ivec2 full = simulation.solver().grid().resolution;
  std::optional<Resampler> resampler;
  if (resolution && *resolution != full) resampler.emplace(full, *resolution, wrapsOf(*simulation.project().field));
  std::vector<glm::vec2> resampled;
  RecordProgress progress{simulation.steps(), stepOfFrame(plan, std::max(frames, 1) - 1, timeStep)};
  for (int frame = 0; frame < frames; ++frame) {
    if (!wanted(frame)) continue;
    for (const long until = stepOfFrame(plan, frame, timeStep); simulation.steps() < until; simulation.step()) {
      progress.step = simulation.steps();
      if (!keepGoing(progress)) return RecordEnd::Cancelled;
    }
    const std::vector<glm::vec2>& cells = simulation.velocity();
    if (resampler) resampler->apply(cells, resampled);
    if (Status taken = take(frame, resampler ? resampled : cells); !taken) return taken.error();
  }
  progress.step = progress.steps;
  keepGoing(progress);
  return RecordEnd::Finished;
}

}  // namespace windloom
