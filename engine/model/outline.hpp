#pragma once
// Outlines of obstacles on the ground and what follows from them: corners, inside test, extent, legality of
// polygons, triangles of a polygon. 2D positions are (x, z) in metres.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/model/project.hpp"

namespace windloom {

inline constexpr std::size_t kMinCorners = 3, kMaxCorners = 256;
inline constexpr float kMaxCornerM = 10000.0f;  ///< from the centre, each component
inline constexpr float kMinCornerGapM = 1e-3f;  ///< between neighbours
inline constexpr float kMinPolygonAreaM2 = 1e-3f;

/// From an obstacle's own axes to the world and back; circles don't turn.
glm::vec2 toWorld(const Obstacle& obstacle, glm::vec2 own);
glm::vec2 toOwn(const Obstacle& obstacle, glm::vec2 world);

/// World corners in order around: those of a box or polygon, `circlePieces` of a circle.
std::vector<glm::vec2> outlineOf(const Obstacle& obstacle, int circlePieces = 48);
/// Whether a place lies in it. A circle's and a box's outline belong to it; a polygon follows the even-odd rule.
bool isInside(const Obstacle& obstacle, glm::vec2 world);
/// No part of it is farther from its centre, m.
float reachOf(const Obstacle& obstacle);
/// Half its extent along its own axes, from the centre to the farther side; circle: the radius twice.
glm::vec2 halfExtentOf(const Obstacle& obstacle);

/// How it stands on the ground: as high over the ground at its centre as it says, down to the lowest ground under its
/// outline. `ground` null: flat at 0.
struct Standing {
  float footM = 0, topM = 0;
};
Standing standingOf(const Obstacle& obstacle, const HeightField* ground);

/// What is wrong with a polygon's corners.
struct OutlineProblem {
  std::optional<std::size_t> corner;  ///< the corner that is wrong; none: the list as a whole
  std::string message;
};
/// Too few or too many corners, one that is not finite or out of range, neighbours at one place, sides that cross or
/// touch, no area. Nothing where the polygon is legal. O(corners^2).
std::optional<OutlineProblem> polygonProblem(std::span<const glm::vec2> corners);

/// Positive where the corners go from +x towards +z, m^2.
float signedArea(std::span<const glm::vec2> corners);
glm::vec2 centroidOf(std::span<const glm::vec2> corners);

/// n - 2 triangles over a legal polygon's corners, each turning from +x towards +z, by cutting off ears (Meisters,
/// "Polygons have ears", 1975).
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const glm::vec2> corners);

}  // namespace windloom
