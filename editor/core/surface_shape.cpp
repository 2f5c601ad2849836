#include "editor/core/surface_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/model/surface_pose.hpp"
#include "engine/model/surface_shapes.hpp"

namespace windloom::editor {
namespace {

constexpr int kRingPieces = 48;

glm::vec2 turned(glm::vec2 way, float degrees) {
  const float angle = glm::radians(degrees), c = std::cos(angle), s = std::sin(angle);
  return {way.x * c - way.y * s, way.x * s + way.y * c};
}

/// Height of the bare ground: marks are drawn higher, things stand on it.
float groundAt(const Ground& ground, glm::vec2 place) {
  return ground.at(place) - ground.over;
}

}  // namespace

SurfaceBox boxOf(const Surface& surface) {
  glm::vec3 low(-0.5f, 0.0f, -0.5f), high(0.5f, 1.0f, 0.5f);
  if (const auto mesh = surfaceMesh(surface)) {
    low = mesh->low;
    high = mesh->high;
  }
  const float angle = glm::radians(surface.tilt), c = std::cos(angle), s = std::sin(angle);
  constexpr float kFar = std::numeric_limits<float>::max();
  SurfaceBox box{glm::vec3(kFar), glm::vec3(-kFar)};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 own(corner % 2 == 0 ? low.x : high.x, corner / 2 % 2 == 0 ? low.y : high.y,
                        corner / 4 == 0 ? low.z : high.z);
    const glm::vec3 tilted = surfaceScale(surface) * glm::vec3(own.x, own.y * c - own.z * s, own.y * s + own.z * c);
    box.low = glm::min(box.low, tilted);
    box.high = glm::max(box.high, tilted);
  }
  box.high.y -= box.low.y;
  box.low.y = 0.0f;
  return box;
}

glm::vec2 toWorld(const Surface& surface, glm::vec2 own) {
  return surface.position + turned(own, surface.rotation);
}

std::vector<glm::vec2> outlineOf(const Surface& surface) {
  const SurfaceBox box = boxOf(surface);
  std::vector<glm::vec2> outline;
  for (const glm::vec2 corner : {glm::vec2(box.low.x, box.low.z), glm::vec2(box.high.x, box.low.z),
                                 glm::vec2(box.high.x, box.high.z), glm::vec2(box.low.x, box.high.z)})
    outline.push_back(toWorld(surface, corner));
  return outline;
}

bool isInside(const Surface& surface, glm::vec2 world) {
  const SurfaceBox box = boxOf(surface);
  const glm::vec2 own = turned(world - surface.position, -surface.rotation);
  return own.x >= box.low.x && own.y >= box.low.z && own.x <= box.high.x && own.y <= box.high.z;
}

float reachOf(const Surface& surface) {
  const SurfaceBox box = boxOf(surface);
  const glm::vec3 far = glm::max(glm::abs(box.low), glm::abs(box.high));
  return glm::length(glm::vec2(far.x, far.z));
}

std::array<glm::vec3, 8> cornersOf(const Surface& surface, const Ground& ground) {
  const std::vector<glm::vec2> outline = outlineOf(surface);
  const float low = groundAt(ground, surface.position) + surface.lift, high = low + boxOf(surface).high.y;
  std::array<glm::vec3, 8> corners;
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = {outline[i].x, low, outline[i].y};
    corners[i + 4] = {outline[i].x, high, outline[i].y};
  }
  return corners;
}

bool meets(const Surface& surface, const Ground& ground, const Ray& ray) {
  const SurfaceBox box = boxOf(surface);
  const glm::vec2 place = turned(glm::vec2(ray.origin.x, ray.origin.z) - surface.position, -surface.rotation);
  const glm::vec2 way = turned({ray.direction.x, ray.direction.z}, -surface.rotation);
  const float base = groundAt(ground, surface.position) + surface.lift;
  const glm::vec3 origin(place.x, ray.origin.y - base, place.y), direction(way.x, ray.direction.y, way.y);
  float enter = 0.0f, leave = std::numeric_limits<float>::max();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) < 1e-9f) {
      if (origin[axis] < box.low[axis] || origin[axis] > box.high[axis]) return false;
      continue;
    }
    const float a = (box.low[axis] - origin[axis]) / direction[axis];
    const float b = (box.high[axis] - origin[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

glm::vec3 hubOf(const Rotor& rotor, const Ground& ground) {
  return {rotor.position.x, groundAt(ground, rotor.position) + rotor.lift, rotor.position.y};
}

std::vector<glm::vec3> ringOf(const Rotor& rotor, const Ground& ground) {
  const glm::vec3 hub = hubOf(rotor, ground);
  std::vector<glm::vec3> ring;
  for (int i = 0; i < kRingPieces; ++i) {
    const float angle = glm::radians(360.0f * static_cast<float>(i) / kRingPieces);
    ring.push_back(hub + rotor.radius * glm::vec3(std::cos(angle), 0.0f, std::sin(angle)));
  }
  return ring;
}

}  // namespace windloom::editor
