#include "engine/render/framing.hpp"

#include <algorithm>

namespace windloom {
namespace {

/// Near and far planes for a world of some size.
void fitPlanes(ViewCamera& camera, float reachM) {
  camera.nearPlane = std::clamp(reachM * 1e-3f, 0.02f, 1.0f);
  camera.farPlane = std::max(2000.0f, 8.0f * reachM);
}

}  // namespace

ViewCamera viewThrough(const Camera& camera) {
  ViewCamera view;
  view.position = camera.position;
  view.target = camera.target;
  view.fieldOfView = camera.fieldOfView;
  return view;
}

ViewCamera frameField(const FieldSettings& field) {
  const float longest = std::max(field.size.x, field.size.y);
  const glm::vec3 centre(field.centre.x, 0.0f, field.centre.y);
  ViewCamera view;
  view.target = centre - glm::vec3(0.0f, 0.0f, 0.06f * longest);
  view.position = centre + glm::vec3(0.06f * longest, 0.30f * longest, 0.5f * field.size.y + 0.42f * longest);
  fitPlanes(view, longest);
  return view;
}

ViewCamera frameFieldFromAbove(const FieldSettings& field) {
  ViewCamera view;
  const float longest = std::max(field.size.x, field.size.y);
  view.target = {field.centre.x, 0.0f, field.centre.y};
  view.position = view.target + glm::vec3(0.0f, longest, 0.0f);
  view.orthographic = true;
  // Wide fields fit a 16:9 picture, tall ones its height.
  view.orthographicHeight = 1.04f * std::max(field.size.y, field.size.x * 9.0f / 16.0f);
  fitPlanes(view, longest);
  return view;
}

}  // namespace windloom
