#pragma once
// Poisson-disk samples on any surface.

#include <atomic>
#include <vector>

#include "engine/grass/growth_area.hpp"

namespace windloom {

/// Takes candidates in their order and leaves out each one that lies closer than `least` m to one taken before and
/// looks to the same side (their `up` less than a right angle apart: the two sides of a thin sheet don't disturb each
/// other). Returns the places of those taken, ascending. Evenly random candidates, some five for each least * least
/// m^2, leave little room for more. Dart throwing (Cook, "Stochastic sampling in computer graphics", 1986) with a
/// hash grid.
std::vector<std::size_t> poissonDisk(const std::vector<GrowthPoint>& candidates, float least,
                                     const std::atomic<bool>* cancelled = nullptr);

}  // namespace windloom
