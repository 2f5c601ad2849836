#pragma once
// Where the picture is taken from.

#include <glm/glm.hpp>

namespace windloom {

struct ViewCamera {
  glm::vec3 position{0.0f, 20.0f, 60.0f};  ///< m
  glm::vec3 target{0.0f, 0.0f, 0.0f};      ///< m
  glm::vec3 up{0.0f, 1.0f, 0.0f};
  float fieldOfView = 45.0f;               ///< deg, vertical; perspective only
  bool orthographic = false;
  float orthographicHeight = 100.0f;       ///< m of the world over the picture's height
  float nearPlane = 0.1f, farPlane = 2000.0f;  ///< m

  [[nodiscard]] glm::mat4 view() const;
  /// OpenGL clip space; `aspect` = width / height.
  [[nodiscard]] glm::mat4 projection(float aspect) const;

  bool operator==(const ViewCamera&) const = default;
};

}  // namespace windloom
