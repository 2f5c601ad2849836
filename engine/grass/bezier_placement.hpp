#pragma once
// Where Bezier grass grows: blades on the ground and on surfaces, grouped in patches. Pure and the same for the same
// input on any number of cores. After Jahrmann & Wimmer, "Responsive real-time grass rendering", 2017, section 3.
//
// Single blades stand uniformly over the area; tufts stand at Poisson-disk samples of the surface. On surfaces tufts
// are smaller and closer as their blades are lower than the ground's. Around the field the ground's blades thin out in
// a ragged margin of kMeadowMarginM, beside those that the density asks for. Patches hold 256 blades each, never of two
// surfaces, are compact and in Morton order; any first part of a patch's blades covers it evenly. A patch's box has
// room for all that bezierValid (bezier_pose.h) makes of any tip, and for a blade's width to each side.

#include <atomic>
#include <vector>

#include "engine/model/project.hpp"
#include "shaders/shared/bezier_blade.h"

namespace windloom {

using shared::BezierBlade;
using shared::BezierPatch;

struct BezierMeadow {
  std::vector<BezierBlade> blades;  ///< 256 for each patch; those of height 0 fill up
  std::vector<BezierPatch> patches;
  long long count = 0;    ///< blades that grow
  double area = 0;        ///< m^2 they grow on
  float widening = 1.0f;  ///< of the ground's blades, where BezierSettings::most lowered the density
};

/// Places all blades of the project's grass of kind Bezier, whatever its kind is. Obstacles are left out: they move.
/// Surfaces that have not been read yet, have no triangles, or are hidden grow nothing. At most kMaxBezierBlades in
/// all. `cancelled` (may be null) is looked at now and then; when it is set the result is empty.
BezierMeadow placeBezier(const Project& project, const std::atomic<bool>* cancelled = nullptr);

/// With more, every part's density is lowered alike.
inline constexpr long long kMaxBezierBlades = 8'000'000;

}  // namespace windloom
