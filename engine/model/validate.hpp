#pragma once
// What makes a project legal beyond the types of its values.

#include <string>
#include <string_view>
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
inline constexpr std::size_t kMaxSpecies = 16;
inline constexpr std::size_t kMaxColliders = 64;
inline constexpr std::size_t kMaxSurfaces = 64;
inline constexpr std::size_t kMaxRotors = 16;
inline constexpr std::size_t kMaxColliderKeys = 10'000;
inline constexpr float kMaxColliderKeyTimeS = 3600.0f;
inline constexpr float kMaxColliderOffsetM = 100'000.0f;  ///< of a key, along each axis
inline constexpr std::size_t kMaxSignalKeys = 10'000;
inline constexpr float kMaxSignalKeyTimeS = 3600.0f;
inline constexpr float kMaxSignalKeyValue = 4.0f;
inline constexpr double kMaxBlades = 200e6;  ///< density x field area
inline constexpr float kMinArrowLengthM = 1e-3f;

/// Where a key's time or value is out of range: what was expected. Empty where it is legal.
std::string signalKeyProblem(const SignalKey& key);

/// Where a collider key's time or offset is out of range: what was expected. Empty where it is legal.
std::string colliderKeyProblem(const ColliderKey& key);

/// Every problem, in file order, with JSON pointers: parameters out of range; ids zero or used twice;
/// arrows to missing points, from a point to itself, or between points at the same place; two arrows
/// with the same ends; signals of missing points, two for one root, or with keys out of range, not
/// ascending or (when looped) after the period; periodic sides without partner; cameras that look at
/// their own place; names of files that are no paths, and none where a terrain or a mesh needs one; colliders'
/// keys out of range or not ascending; a gravity without direction; counts over the limits. Empty: valid.
std::vector<Problem> validate(const Project& project);

/// The same for a project made from a valid one: parts that it shares with `valid` are not read again,
/// except for what binds parts together.
std::vector<Problem> validateChange(const Project& project, const Project& valid);

}  // namespace windloom
