#pragma once
// What closes the view: hills in the haze and the edge of an autumn wood round the meadow. Made once, never changed.

#include <vector>

#include "maths.hpp"
#include "wind_source.hpp"

namespace game {

struct HillCorner {
  Vec3 direction;
  Vec3 colour;
  float haze;  ///< 0..1: part of the horizon's colour
};

struct WoodCorner {
  Vec3 position;
  Vec3 colour;
};

/// Triangles, the farthest hills first.
std::vector<HillCorner> hills(std::uint32_t seed);
/// Triangles, the farthest trees first.
std::vector<WoodCorner> wood(const Bounds& meadow, std::uint32_t seed);

}  // namespace game
