#pragma once
// Runs a simulation and takes frames from it at exact times.

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <span>

#include "engine/core/result.hpp"
#include "engine/session/simulation.hpp"

namespace windloom {

/// Which moments are recorded.
struct RecordPlan {
  double from = 0;    ///< s: moment of frame 0
  double fps = 30;    ///< frames a second
  int frames = 1;     ///< how many are written
  int crossfade = 0;  ///< so many more are recorded and blended into the first ones, which makes a loop
};

/// The simulation's step from whose field frame `n` is taken: the first at or after `from + n / fps`. Rounding noise
/// in the step (a float of 1/60) doesn't push a frame to the next step.
long stepOfFrame(const RecordPlan& plan, int n, double timeStep);

/// Frames blended into the seam of a loop of `frames`: a quarter of them.
int crossfadeFor(int frames);

/// Weight of recorded frame `frames + n` in written frame `n` is 1 - this; that of recorded frame `n` is this. 1 where
/// nothing is blended. The field stays free of divergence, since the blend is linear.
float seamWeight(const RecordPlan& plan, int n);

struct RecordProgress {
  long step = 0, steps = 0;
};

enum class RecordEnd { Finished, Cancelled };

/// Steps `simulation` from where it stands (at or before the first frame's step) through all frames of the plan, seam
/// included, that `wanted` asks for, and gives each of those to `take` in order, resampled to `resolution` where one is
/// given. `keepGoing` is asked at each step. Fails with what `take` fails with.
Result<RecordEnd> record(Simulation& simulation, const RecordPlan& plan, const std::optional<glm::ivec2>& resolution,
                         const std::function<bool(int frame)>& wanted,
                         const std::function<Status(int frame, std::span<const glm::vec2> cells)>& take,
                         const std::function<bool(const RecordProgress&)>& keepGoing);

}  // namespace windloom
