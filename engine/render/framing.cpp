#include "engine/render/framing.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

constexpr float kPictureAspect = 16.0f / 9.0f;

/// Near and far planes for a world of some size.
void fitPlanes(ViewCamera& camera, float reachM) {
  camera.nearPlane = std::clamp(reachM * 1e-3f, 0.02f, 1.0f);
  camera.farPlane = std::max(2000.0f, 8.0f * reachM);
}

HeightRange rangeOf(const FieldSettings& field, const HeightField* ground) {
  if (ground == nullptr) return {};
  return heightsOver(*ground, field.centre - 0.5f * field.size, field.centre + 0.5f * field.size);
}

}  // namespace

ViewCamera viewThrough(const Camera& camera) {
  ViewCamera view;
  view.position = camera.position;
  view.target = camera.target;
  view.fieldOfView = camera.fieldOfView;
  return view;
}

ViewCamera frameField(const FieldSettings& field, const HeightField* ground) {
  const glm::vec3 forward = glm::normalize(glm::vec3(-0.06f, -0.42f, -1.0f));
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0.0f, 1.0f, 0.0f)));
  const glm::vec3 up = glm::cross(right, forward);
  const HeightRange range = rangeOf(field, ground);
  const float half = 0.5f * (range.highest - range.lowest);
  ViewCamera view;
  view.target = {field.centre.x, range.lowest + half, field.centre.y};
  const float tanUp = std::tan(0.5f * glm::radians(view.fieldOfView)), tanRight = tanUp * kPictureAspect;
  float distance = 0.0f;
  for (const glm::vec2 corner :
       {glm::vec2(-0.5f, -0.5f), glm::vec2(0.5f, -0.5f), glm::vec2(-0.5f, 0.5f), glm::vec2(0.5f, 0.5f)}) {
    for (const float y : {-half, half}) {
      const glm::vec3 at(corner.x * field.size.x, y, corner.y * field.size.y);
      const float reach = std::max(std::abs(glm::dot(at, right)) / tanRight, std::abs(glm::dot(at, up)) / tanUp);
      distance = std::max(distance, reach - glm::dot(at, forward));
    }
  }
  view.position = view.target - forward * distance;
  if (ground != nullptr)
    view.position.y = std::max(view.position.y, heightAt(*ground, {view.position.x, view.position.z}) + 2.0f);
  fitPlanes(view, distance);
  return view;
}

ViewCamera frameFieldFromAbove(const FieldSettings& field, const HeightField* ground) {
  ViewCamera view;
  const float longest = std::max(field.size.x, field.size.y);
  const HeightRange range = rangeOf(field, ground);
  view.target = {field.centre.x, range.lowest, field.centre.y};
  // Ground around the field may be higher than what is in it.
  const float top = ground != nullptr ? std::max(ground->highest(), range.highest) - range.lowest : 0.0f;
  view.position = view.target + glm::vec3(0.0f, longest + top, 0.0f);
  view.orthographic = true;
  // Wide fields fit a 16:9 picture, tall ones its height.
  view.orthographicHeight = 1.04f * std::max(field.size.y, field.size.x / kPictureAspect);
  fitPlanes(view, longest + top);
  return view;
}

}  // namespace windloom
