#pragma once
// What makes a project legal beyond the types of its values.

#include <vector>

#include "engine/core/result.hpp"
#include "engine/model/project.hpp"

namespace windloom {

// Limits a file can't exceed, checked before anything is allocated.
inline constexpr std::size_t kMaxPoints = 100'000;
inline constexpr std::size_t kMaxArrows = 100'000;
inline constexpr std::size_t kMaxObstacles = 10'000;
inline constexpr std::size_t kMaxProbes = 1'000;
inline constexpr std::size_t kMaxCameras = 1'000;
inline constexpr std::size_t kMaxSignalKeys = 10'000;
inline constexpr double kMaxBlades = 200e6;  ///< density x field area

/// Every problem, in file order, with JSON pointers: parameters out of range; ids zero or used twice;
/// arrows to missing points, from a point to itself, or between points at the same place; two arrows
/// with the same ends; signals of missing points, two for one root, or with keys not ascending;
/// periodic sides without partner; counts over the limits. Empty: valid.
std::vector<Problem> validate(const Project& project);

}  // namespace windloom
