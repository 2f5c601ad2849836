#pragma once
// The ground that tools draw on.

#include <glm/glm.hpp>
#include <memory>
#include <optional>

#include "engine/model/height_field.hpp"

namespace windloom::editor {

struct Ray {
  glm::vec3 origin{0.0f};
  glm::vec3 direction{0.0f, -1.0f, 0.0f};  ///< unit
};

struct Ground {
  std::shared_ptr<const HeightField> height;  ///< null: flat at 0
  float over = 0;  ///< m over the ground: where marks are drawn, so that a handle lies on its mark (markHeight)

  [[nodiscard]] float at(glm::vec2 position) const { return over + (height ? heightAt(*height, position) : 0.0f); }
  [[nodiscard]] glm::vec3 lift(glm::vec2 position) const { return {position.x, at(position), position.y}; }
};

/// The nearest place where the ray meets the ground, raised by `over`, from above within `reach` m.
std::optional<glm::vec2> hitGround(const Ray& ray, const Ground& ground, float reach = 4000.0f);

}  // namespace windloom::editor
