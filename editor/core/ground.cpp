#include "editor/core/ground.hpp"

#include <cmath>

namespace windloom::editor {
namespace {

std::optional<float> hitFlat(const Ray& ray, float reach) {
  if (std::abs(ray.direction.y) < 1e-6f) return std::nullopt;
  const float t = -ray.origin.y / ray.direction.y;
  if (t < 0.0f || t > reach) return std::nullopt;
  return t;
}

}  // namespace

std::optional<glm::vec2> hitGround(const Ray& ray, const Ground& ground, float reach) {
  const Ray lowered{ray.origin - glm::vec3(0.0f, ground.over, 0.0f), ray.direction};
  const auto t =
      ground.height ? hitHeights(*ground.height, lowered.origin, lowered.direction, reach) : hitFlat(lowered, reach);
  if (!t) return std::nullopt;
  const glm::vec3 place = lowered.origin + *t * lowered.direction;
  return glm::vec2(place.x, place.z);
}

}  // namespace windloom::editor
