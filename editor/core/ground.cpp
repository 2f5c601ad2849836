#include "editor/core/ground.hpp"

#include <algorithm>
#include <cmath>

namespace windloom::editor {
namespace {

std::optional<glm::vec2> hitFlat(const Ray& ray, float reach) {
  if (std::abs(ray.direction.y) < 1e-6f) return std::nullopt;
  const float t = -ray.origin.y / ray.direction.y;
  if (t < 0.0f || t > reach) return std::nullopt;
  const glm::vec3 place = ray.origin + t * ray.direction;
  return glm::vec2(place.x, place.z);
}

}  // namespace

std::optional<glm::vec2> hitGround(const Ray& ray, const Ground& ground, float reach) {
  if (!ground.height) return hitFlat(ray, reach);
  const auto above = [&](float t) {
    const glm::vec3 place = ray.origin + t * ray.direction;
    return place.y - ground.at({place.x, place.z});
  };
  // The step grows with the distance, as what a pixel covers does; near the camera it is half a metre.
  float low = 0.0f;
  bool wasAbove = above(0.0f) >= 0.0f;
  for (float t = 0.0f; t < reach;) {
    t = std::min(reach, t + std::max(0.5f, 0.01f * t));
    const bool isAbove = above(t) >= 0.0f;
    if (wasAbove && !isAbove) {
      float high = t;
      while (high - low > 0.01f) {
        const float middle = 0.5f * (low + high);
        if (middle <= low || middle >= high) break;
        (above(middle) >= 0.0f ? low : high) = middle;
      }
      const glm::vec3 place = ray.origin + 0.5f * (low + high) * ray.direction;
      return glm::vec2(place.x, place.z);
    }
    wasAbove = isAbove;
    low = t;
  }
  return std::nullopt;
}

}  // namespace windloom::editor
