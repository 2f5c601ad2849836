#include "engine/model/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/core/text.hpp"
#include "engine/model/height_field.hpp"

namespace windloom {
namespace {

using Corners = std::span<const glm::vec2>;

constexpr int kMostSidePieces = 32;  // places along a side where the ground under it is looked at

double cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

/// On which side of the line from a to b the place lies: -1, 0, 1.
int sideOf(glm::dvec2 a, glm::dvec2 b, glm::dvec2 place) {
  const double value = cross(b - a, place - a);
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

bool withinBox(glm::dvec2 a, glm::dvec2 b, glm::dvec2 place) {
  return place.x >= std::min(a.x, b.x) && place.x <= std::max(a.x, b.x) && place.y >= std::min(a.y, b.y) &&
         place.y <= std::max(a.y, b.y);
}

bool segmentsMeet(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  const int ac = sideOf(a, b, c), ad = sideOf(a, b, d), ca = sideOf(c, d, a), cb = sideOf(c, d, b);
  if (ac != ad && ca != cb) return true;
  return (ac == 0 && withinBox(a, b, c)) || (ad == 0 && withinBox(a, b, d)) || (ca == 0 && withinBox(c, d, a)) ||
         (cb == 0 && withinBox(c, d, b));
}

/// Neighbouring sides may only share their corner, not turn back over each other.
bool foldsBack(glm::dvec2 before, glm::dvec2 corner, glm::dvec2 after) {
  return sideOf(before, corner, after) == 0 && glm::dot(before - corner, after - corner) > 0;
}

std::optional<OutlineProblem> cornerProblem(Corners corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const bool legal = std::abs(corners[i].x) <= kMaxCornerM && std::abs(corners[i].y) <= kMaxCornerM;
    if (!legal)
      return OutlineProblem{i, "is out of range: expected two numbers from -" + shortest(kMaxCornerM) + " to " +
                                   shortest(kMaxCornerM) + " (m)"};
    const std::size_t next = (i + 1) % corners.size();
    if (glm::distance(corners[i], corners[next]) < kMinCornerGapM)
      return OutlineProblem{next, "lies where the corner before it does, expected at least " +
                                      shortest(kMinCornerGapM) + " m between them"};
  }
  return std::nullopt;
}

bool crossesItself(Corners corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (foldsBack(corners[i], corners[(i + 1) % n], corners[(i + 2) % n])) return true;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours around the end
      if (segmentsMeet(corners[i], corners[i + 1], corners[j], corners[(j + 1) % n])) return true;
    }
  }
  return false;
}

bool inTriangle(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 place) {
  return sideOf(a, b, place) >= 0 && sideOf(b, c, place) >= 0 && sideOf(c, a, place) >= 0;
}

/// Whether the corner at `at` of the ring can be cut off: convex, with no other corner in its triangle.
bool isEar(Corners corners, const std::vector<std::uint32_t>& ring, std::size_t at) {
  const std::size_t n = ring.size();
  const std::uint32_t a = ring[(at + n - 1) % n], b = ring[at], c = ring[(at + 1) % n];
  if (sideOf(corners[a], corners[b], corners[c]) <= 0) return false;
  return std::ranges::none_of(ring, [&](std::uint32_t other) {
    if (other == a || other == b || other == c) return false;
    return inTriangle(corners[a], corners[b], corners[c], corners[other]);
  });
}

/// Rounding may leave no proper ear; then the least reflex corner goes, which leaves a sliver at worst.
std::size_t nextEar(Corners corners, const std::vector<std::uint32_t>& ring) {
  const std::size_t n = ring.size();
  std::size_t best = 0;
  double most = -1e300;
  for (std::size_t i = 0; i < n; ++i) {
    if (isEar(corners, ring, i)) return i;
    const glm::dvec2 a = corners[ring[(i + n - 1) % n]], b = corners[ring[i]], c = corners[ring[(i + 1) % n]];
    const double turn = cross(b - a, c - b) / std::max(1e-12, glm::length(b - a) * glm::length(c - b));
    // A corner on a straight line holds no area and is no ear while another one is left.
    if (turn > most && std::abs(turn) > 1e-9) {
      most = turn;
      best = i;
    }
  }
  return best;
}

}  // namespace

glm::vec2 toWorld(const Obstacle& obstacle, glm::vec2 own) {
  if (obstacle.shape == ObstacleShape::Circle) return obstacle.centre + own;
  const float angle = glm::radians(obstacle.rotation), c = std::cos(angle), s = std::sin(angle);
  return obstacle.centre + glm::vec2(c * own.x - s * own.y, s * own.x + c * own.y);
}

glm::vec2 toOwn(const Obstacle& obstacle, glm::vec2 world) {
  const glm::vec2 d = world - obstacle.centre;
  if (obstacle.shape == ObstacleShape::Circle) return d;
  const float angle = glm::radians(obstacle.rotation), c = std::cos(angle), s = std::sin(angle);
  return {d.x * c + d.y * s, d.y * c - d.x * s};
}

std::vector<glm::vec2> outlineOf(const Obstacle& obstacle, int circlePieces) {
  std::vector<glm::vec2> outline;
  if (obstacle.shape == ObstacleShape::Circle) {
    for (int i = 0; i < circlePieces; ++i) {
      const float angle = glm::radians(360.0f * static_cast<float>(i) / static_cast<float>(circlePieces));
      outline.push_back(obstacle.centre + obstacle.radius * glm::vec2(std::cos(angle), std::sin(angle)));
    }
  } else if (obstacle.shape == ObstacleShape::Box) {
    const glm::vec2 half = 0.5f * obstacle.size;
    for (const glm::vec2 sign : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
      outline.push_back(toWorld(obstacle, sign * half));
  } else {
    for (const glm::vec2 corner : obstacle.points) outline.push_back(toWorld(obstacle, corner));
  }
  return outline;
}

bool isInside(const Obstacle& obstacle, glm::vec2 world) {
  const glm::vec2 own = toOwn(obstacle, world);
  if (obstacle.shape == ObstacleShape::Circle) return glm::dot(own, own) <= obstacle.radius * obstacle.radius;
  if (obstacle.shape == ObstacleShape::Box)
    return std::abs(own.x) <= obstacle.size.x / 2 && std::abs(own.y) <= obstacle.size.y / 2;
  bool inside = false;
  const std::size_t n = obstacle.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::vec2 a = obstacle.points[i], b = obstacle.points[(i + 1) % n];
    if ((a.y > own.y) == (b.y > own.y)) continue;
    if (own.x < a.x + (own.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

float reachOf(const Obstacle& obstacle) {
  if (obstacle.shape == ObstacleShape::Circle) return obstacle.radius;
  if (obstacle.shape == ObstacleShape::Box) return 0.5f * glm::length(obstacle.size);
  float reach = 0.0f;
  for (const glm::vec2 corner : obstacle.points) reach = std::max(reach, glm::length(corner));
  return reach;
}

glm::vec2 halfExtentOf(const Obstacle& obstacle) {
  if (obstacle.shape == ObstacleShape::Circle) return glm::vec2(obstacle.radius);
  if (obstacle.shape == ObstacleShape::Box) return 0.5f * obstacle.size;
  glm::vec2 half(0.0f);
  for (const glm::vec2 corner : obstacle.points) half = glm::max(half, glm::abs(corner));
  return half;
}

Standing standingOf(const Obstacle& obstacle, const HeightField* ground) {
  if (ground == nullptr) return {0.0f, obstacle.height};
  const float middle = heightAt(*ground, obstacle.centre);
  float lowest = middle;
  const std::vector<glm::vec2> corners = outlineOf(obstacle);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
    const int pieces = std::clamp(static_cast<int>(std::ceil(glm::distance(a, b))), 1, kMostSidePieces);
    for (int piece = 0; piece < pieces; ++piece) {
      const float along = static_cast<float>(piece) / static_cast<float>(pieces);
      lowest = std::min(lowest, heightAt(*ground, glm::mix(a, b, along)));
    }
  }
  return {lowest, middle + obstacle.height};
}

std::optional<OutlineProblem> polygonProblem(Corners corners) {
  if (corners.size() < kMinCorners || corners.size() > kMaxCorners)
    return OutlineProblem{{},
                          "holds " + std::to_string(corners.size()) + " corners, expected " +
                              std::to_string(kMinCorners) + " to " + std::to_string(kMaxCorners)};
  if (auto problem = cornerProblem(corners)) return problem;
  if (crossesItself(corners)) return OutlineProblem{{}, "has sides that cross or touch each other"};
  if (!(std::abs(signedArea(corners)) >= kMinPolygonAreaM2))
    return OutlineProblem{{}, "encloses no area, expected at least " + shortest(kMinPolygonAreaM2) + " m^2"};
  return std::nullopt;
}

float signedArea(Corners corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) sum += cross(corners[i], corners[(i + 1) % corners.size()]);
  return static_cast<float>(0.5 * sum);
}

glm::vec2 centroidOf(Corners corners) {
  if (corners.empty()) return glm::vec2(0.0f);
  glm::dvec2 sum(0.0), mean(0.0);
  double twice = 0;
  const glm::dvec2 origin = corners[0];  // near the corners, so that nothing cancels far from the world's origin
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 a = glm::dvec2(corners[i]) - origin, b = glm::dvec2(corners[(i + 1) % corners.size()]) - origin;
    twice += cross(a, b);
    sum += (a + b) * cross(a, b);
    mean += a / static_cast<double>(corners.size());
  }
  return origin + (std::abs(twice) > 1e-9 ? sum / (3 * twice) : mean);
}

std::vector<std::array<std::uint32_t, 3>> triangulate(Corners corners) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (corners.size() < 3) return triangles;
  std::vector<std::uint32_t> ring(corners.size());
  std::iota(ring.begin(), ring.end(), 0u);
  if (signedArea(corners) < 0) std::ranges::reverse(ring);
  while (ring.size() > 3) {
    const std::size_t n = ring.size(), at = nextEar(corners, ring);
    triangles.push_back({ring[(at + n - 1) % n], ring[at], ring[(at + 1) % n]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(at));
  }
  triangles.push_back({ring[0], ring[1], ring[2]});
  return triangles;
}

}  // namespace windloom
