#include "editor/core/project_cameras.hpp"

#include <algorithm>
#include <cmath>

namespace windloom::editor {

EditorCamera lookThrough(const EditorCamera& view, const Camera& camera) {
  EditorCamera seen = view;
  const glm::vec3 way = camera.target - camera.position;
  const float length = std::max(glm::length(way), 1e-3f);
  seen.target = camera.target;
  seen.distance = length;
  seen.fieldOfView = camera.fieldOfView;
  seen.orthographic = false;
  seen.pitch = glm::degrees(std::asin(std::clamp(-way.y / length, -1.0f, 1.0f)));
  // Straight down there is no heading: north stays up.
  const bool level = glm::length(glm::vec2(way.x, way.z)) > 1e-4f * length;
  seen.yaw = level ? glm::degrees(std::atan2(-way.x, -way.z)) : 0.0f;
  return seen;
}

const Camera* openingCamera(const Project& project) {
  const auto hero = std::ranges::find(*project.cameras, "hero", &Camera::name);
  if (hero != project.cameras->end()) return &*hero;
  return project.cameras->empty() ? nullptr : &project.cameras->front();
}

AddResult addCameraEdit(const Project& project, const EditorCamera& view) {
  AddResult result{{}, nextFreeId(project)};
  Camera camera;
  camera.id = result.id;
  for (int number = 1; camera.name.empty(); ++number) {
    const std::string name = "camera " + std::to_string(number);
    if (std::ranges::find(*project.cameras, name, &Camera::name) == project.cameras->end()) camera.name = name;
  }
  camera.position = view.position();
  camera.target = view.target;
  camera.fieldOfView = view.fieldOfView;
  result.edit.label = "Store camera";
  result.edit.steps.emplace_back(Put<Camera>{std::move(camera)});
  return result;
}

}  // namespace windloom::editor
