#include "engine/render/view_camera.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace windloom {

glm::mat4 ViewCamera::view() const {
  glm::vec3 forward = target - position;
  if (glm::dot(forward, forward) < 1e-12f) forward = {0.0f, 0.0f, -1.0f};
  forward = glm::normalize(forward);
  // Looking along `up` (a top view with +Y up) leaves the roll open: the top of the picture is then -Z.
  const bool along = std::abs(glm::dot(forward, glm::normalize(up))) > 0.9999f;
  return glm::lookAt(position, position + forward, along ? glm::vec3(0.0f, 0.0f, -1.0f) : up);
}

glm::mat4 ViewCamera::projection(float aspect) const {
  if (orthographic) {
    const float half = 0.5f * orthographicHeight;
    return glm::ortho(-half * aspect, half * aspect, -half, half, nearPlane, farPlane);
  }
  return glm::perspective(glm::radians(fieldOfView), aspect, nearPlane, farPlane);
}

}  // namespace windloom
