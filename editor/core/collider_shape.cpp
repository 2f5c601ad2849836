#include "editor/core/collider_shape.hpp"

#include <algorithm>
#include <cmath>

#include "engine/model/collider_motion.hpp"

namespace windloom::editor {
namespace {

constexpr int kCirclePieces = 48;

/// Extent of a mesh seen from above: its front is +z in its file, and its first axis here.
struct Rectangle {
  glm::vec2 low{-0.5f}, high{0.5f};
};

Rectangle extentOf(const Collider& collider) {
  Rectangle extent;
  if (collider.mesh) {
    extent.low = {collider.mesh->low.z, -collider.mesh->high.x};
    extent.high = {collider.mesh->high.z, -collider.mesh->low.x};
  }
  return {extent.low * collider.scale, extent.high * collider.scale};
}

/// Half the way between the middles of a capsule's ends.
float halfLength(const Collider& collider) {
  return collider.shape == ColliderShape::Capsule ? 0.5f * collider.length : 0.0f;
}

glm::vec2 toOwn(const Collider& collider, glm::vec2 world) {
  const float angle = glm::radians(collider.rotation), c = std::cos(angle), s = std::sin(angle);
  const glm::vec2 d = world - collider.position;
  return {d.x * c + d.y * s, d.y * c - d.x * s};
}

}  // namespace

glm::vec2 toWorld(const Collider& collider, glm::vec2 own) {
  if (collider.shape == ColliderShape::Sphere) return collider.position + own;
  const float angle = glm::radians(collider.rotation), c = std::cos(angle), s = std::sin(angle);
  return collider.position + glm::vec2(own.x * c - own.y * s, own.x * s + own.y * c);
}

std::vector<glm::vec2> outlineOf(const Collider& collider) {
  std::vector<glm::vec2> outline;
  if (collider.shape == ColliderShape::Mesh) {
    const auto [low, high] = extentOf(collider);
    for (const glm::vec2 corner : {low, glm::vec2(high.x, low.y), high, glm::vec2(low.x, high.y)})
      outline.push_back(toWorld(collider, corner));
    return outline;
  }
  for (int i = 0; i < kCirclePieces; ++i) {
    const float angle = glm::radians(360.0f * (static_cast<float>(i) + 0.5f) / kCirclePieces);
    const glm::vec2 way(std::cos(angle), std::sin(angle));
    outline.push_back(
        toWorld(collider, collider.radius * way + glm::vec2(std::copysign(halfLength(collider), way.x), 0.0f)));
  }
  return outline;
}

bool isInside(const Collider& collider, glm::vec2 world) {
  const glm::vec2 own = toOwn(collider, world);
  if (collider.shape == ColliderShape::Mesh) {
    const auto [low, high] = extentOf(collider);
    return own.x >= low.x && own.y >= low.y && own.x <= high.x && own.y <= high.y;
  }
  const float half = halfLength(collider);
  return glm::distance(own, glm::vec2(std::clamp(own.x, -half, half), 0.0f)) <= collider.radius;
}

float reachOf(const Collider& collider) {
  if (collider.shape != ColliderShape::Mesh) return collider.radius + halfLength(collider);
  const auto [low, high] = extentOf(collider);
  return glm::length(glm::max(glm::abs(low), glm::abs(high)));
}

Collider shownAt(const Collider& collider, double seconds) {
  Collider shown;
  shown.id = collider.id;
  shown.shape = collider.shape;
  shown.radius = collider.radius;
  shown.length = collider.length;
  shown.scale = collider.scale;
  shown.file = collider.file;
  shown.mesh = collider.mesh;
  shown.hidden = collider.hidden;
  shown.muted = collider.muted;
  shown.locked = collider.locked;
  const glm::vec3 offset = colliderOffset(collider, seconds);
  shown.position = collider.position + glm::vec2(offset.x, offset.z);
  shown.lift = collider.lift + offset.y;
  shown.rotation = glm::degrees(colliderHeading(collider, seconds));
  return shown;
}

std::vector<glm::vec2> wayOf(const Collider& collider) {
  std::vector<glm::vec2> way;
  for (const ColliderKey& key : collider.keys) way.push_back(collider.position + glm::vec2(key.offset.x, key.offset.z));
  if (way.empty()) way.push_back(collider.position);
  return way;
}

}  // namespace windloom::editor
