#pragma once
// The ground that tools draw on.

#include <functional>
#include <glm/glm.hpp>
#include <optional>

namespace windloom::editor {

struct Ray {
  glm::vec3 origin{0.0f};
  glm::vec3 direction{0.0f, -1.0f, 0.0f};  ///< unit
};

struct Ground {
  std::function<float(glm::vec2)> height;  ///< m at (x, z); empty: flat at 0

  [[nodiscard]] float at(glm::vec2 position) const { return height ? height(position) : 0.0f; }
  [[nodiscard]] glm::vec3 lift(glm::vec2 position) const { return {position.x, at(position), position.y}; }
};

/// The nearest place where the ray meets the ground within `reach` m. On uneven ground the ray is marched
/// and the crossing refined to about 1 cm.
std::optional<glm::vec2> hitGround(const Ray& ray, const Ground& ground, float reach = 4000.0f);

}  // namespace windloom::editor
