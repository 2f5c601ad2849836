#pragma once
// The calibration card: a wind that is known everywhere and at all times, so that a game can check an export of it.
// It turns once in kCardPeriod and carries a code of each axis: the wind along x tells z, the wind along z tells x. So
// a mirrored, swapped or shifted axis, another unit and a wrong moment all show. Free of divergence, periodic in both
// axes.

#include <glm/glm.hpp>

namespace windloom {

inline constexpr float kCardPeriod = 4.0f;  ///< s
inline constexpr float kCardSpeed = 5.0f;  ///< m/s of the part that turns: along +x at time 0, along +z a quarter later
inline constexpr float kCardCode = 2.0f;   ///< m/s of the part that tells the place
inline constexpr float kCardFastest = 7.83f;  ///< m/s: nowhere is more than kCardSpeed + sqrt(2) kCardCode

/// Wind in m/s at `part` of the field (0..1 along x and z) and time `seconds`. The shader code of
/// engine/bake/sidecars has the same lines.
glm::vec2 cardWind(glm::vec2 part, double seconds);

}  // namespace windloom
