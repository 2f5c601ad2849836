#include "editor/core/camera_control.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace windloom::editor {
namespace {

constexpr float kDegreesPerPixel = 0.3f;  // a turn takes about a 1200-pixel sweep
constexpr float kZoomPerNotch = 0.87f;
constexpr float kMinDistance = 0.5f, kMaxDistance = 3000.0f;
constexpr float kMinPitch = -89.0f, kMaxPitch = 90.0f;

float wrapDegrees(float degrees) {
  return std::remainder(degrees, 360.0f);
}

/// Half the height of the view at the target's distance, m.
float halfHeight(const EditorCamera& camera) {
  return camera.distance * std::tan(0.5f * glm::radians(camera.fieldOfView));
}

}  // namespace

glm::vec3 EditorCamera::forward() const {
  const float y = glm::radians(yaw), p = glm::radians(pitch);
  return {-std::sin(y) * std::cos(p), -std::sin(p), -std::cos(y) * std::cos(p)};
}
glm::vec3 EditorCamera::right() const {
  const float y = glm::radians(yaw);
  return {std::cos(y), 0.0f, -std::sin(y)};
}
glm::vec3 EditorCamera::up() const {
  const float y = glm::radians(yaw), p = glm::radians(pitch);
  return {-std::sin(y) * std::sin(p), std::cos(p), -std::cos(y) * std::sin(p)};
}
glm::vec3 EditorCamera::position() const {
  return target - distance * forward();
}

CameraPose EditorCamera::pose() const {
  CameraPose pose;
  pose.position = position();
  pose.target = target;
  pose.up = up();
  pose.fieldOfView = fieldOfView;
  pose.orthographic = orthographic;
  pose.orthographicHeight = 2.0f * halfHeight(*this);
  // Hills between eye and target, or behind the eye, belong to a view without perspective as well.
  pose.nearPlane = orthographic ? -1000.0f : std::clamp(0.01f * distance, 0.05f, 1.0f);
  pose.farPlane = std::max(2000.0f, 4.0f * distance);
  return pose;
}

ViewMapping::ViewMapping(const EditorCamera& camera, glm::vec2 size)
    : m_camera(camera),
      m_size(glm::max(size, glm::vec2(1.0f))),
      m_position(camera.position()),
      m_forward(camera.forward()),
      m_right(camera.right()),
      m_up(camera.up()),
      m_focal(0.5f * m_size.y /
              (camera.orthographic ? halfHeight(camera) : std::tan(0.5f * glm::radians(camera.fieldOfView)))) {}

Ray ViewMapping::ray(glm::vec2 pixel) const {
  const glm::vec2 offset = (pixel - 0.5f * m_size) / m_focal;
  if (m_camera.orthographic) {
    // From far behind the target, so that no ground in front of it is cut away.
    const glm::vec3 origin = m_position + offset.x * m_right - offset.y * m_up - 1000.0f * m_forward;
    return {origin, m_forward};
  }
  return {m_position, glm::normalize(m_forward + offset.x * m_right - offset.y * m_up)};
}

std::optional<glm::vec2> ViewMapping::toScreen(glm::vec3 world) const {
  const glm::vec3 relative = world - m_position;
  const float depth = glm::dot(relative, m_forward);
  glm::vec2 plane(glm::dot(relative, m_right), -glm::dot(relative, m_up));
  if (!m_camera.orthographic) {
    if (depth < 0.01f) return std::nullopt;
    plane /= depth;
  }
  return 0.5f * m_size + m_focal * plane;
}

std::optional<glm::vec2> ViewMapping::toGround(glm::vec2 pixel, const Ground& ground) const {
  return hitGround(ray(pixel), ground, m_camera.orthographic ? 8000.0f : 4000.0f);
}

std::optional<glm::vec2> ViewMapping::groundToScreen(glm::vec2 world, const Ground& ground) const {
  return toScreen(ground.lift(world));
}

float ViewMapping::metresPerPixel(glm::vec3 world) const {
  if (m_camera.orthographic) return 1.0f / m_focal;
  return std::max(0.01f, glm::dot(world - m_position, m_forward)) / m_focal;
}

EditorCamera orbit(EditorCamera camera, glm::vec2 delta) {
  camera.yaw = wrapDegrees(camera.yaw - delta.x * kDegreesPerPixel);
  camera.pitch = std::clamp(camera.pitch + delta.y * kDegreesPerPixel, kMinPitch, kMaxPitch);
  return camera;
}

EditorCamera pan(EditorCamera camera, glm::vec2 delta, glm::vec2 viewport) {
  const float metres = 2.0f * halfHeight(camera) / std::max(1.0f, viewport.y);
  camera.target += metres * (delta.y * camera.up() - delta.x * camera.right());
  return camera;
}

EditorCamera zoomTo(EditorCamera camera, float notches, glm::vec2 pixel, glm::vec2 viewport, const Ground& ground) {
  const ViewMapping before(camera, viewport);
  const float distance = std::clamp(camera.distance * std::pow(kZoomPerNotch, notches), kMinDistance, kMaxDistance);
  const float factor = distance / camera.distance;
  // Scaling the whole view around the place under the pointer keeps that place where it is. Far off,
  // towards the horizon, the target's depth stands in for it, or one notch would cross the country.
  glm::vec3 anchor = camera.target;
  const Ray ray = before.ray(pixel);
  const auto hit = before.toGround(pixel, ground);
  const float targetDepth = glm::dot(camera.target - ray.origin, camera.forward());
  glm::vec3 fallback = ray.origin + ray.direction * (targetDepth / glm::dot(ray.direction, camera.forward()));
  if (hit && glm::distance(ground.lift(*hit), camera.target) < 4.0f * camera.distance) {
    anchor = ground.lift(*hit);
  } else {
    anchor = fallback;
  }
  camera.target = anchor + factor * (camera.target - anchor);
  camera.distance = distance;
  return camera;
}

EditorCamera lookAround(EditorCamera camera, glm::vec2 delta) {
  const glm::vec3 stand = camera.position();
  camera.yaw = wrapDegrees(camera.yaw - delta.x * 0.6f * kDegreesPerPixel);
  camera.pitch = std::clamp(camera.pitch + delta.y * 0.6f * kDegreesPerPixel, kMinPitch, kMaxPitch);
  camera.target = stand + camera.distance * camera.forward();
  return camera;
}

EditorCamera fly(EditorCamera camera, glm::vec3 move, float metresPerSecond, float seconds) {
  const float length = glm::length(move);
  if (length < 1e-4f) return camera;
  const glm::vec3 direction =
      (move.x * camera.right() + move.y * glm::vec3(0.0f, 1.0f, 0.0f) + move.z * camera.forward()) / length;
  camera.target += direction * metresPerSecond * seconds;
  return camera;
}

EditorCamera lookAlong(EditorCamera camera, ViewDirection direction) {
  camera.orthographic = true;
  camera.yaw = direction == ViewDirection::Side ? 90.0f : 0.0f;
  camera.pitch = direction == ViewDirection::Top ? 90.0f : 0.0f;
  return camera;
}

EditorCamera frameBounds(EditorCamera camera, glm::vec2 low, glm::vec2 high, glm::vec2 viewport, const Ground& ground) {
  const glm::vec2 centre = 0.5f * (low + high);
  HeightRange heights{camera.target.y, camera.target.y};
  if (ground.height) heights = heightsOver(*ground.height, low, high);
  const float half = 0.5f * (heights.highest - heights.lowest);
  camera.target = {centre.x, heights.lowest + half, centre.y};
  constexpr float kMargin = 1.2f;
  const float aspect = std::max(0.1f, viewport.x / std::max(1.0f, viewport.y));
  const float tangent = std::tan(0.5f * glm::radians(camera.fieldOfView));
  float distance = 1.0f / tangent;
  for (const glm::vec2 corner : {low, high, glm::vec2(low.x, high.y), glm::vec2(high.x, low.y)}) {
    for (const float y : {-half, half}) {
      const glm::vec3 offset(corner.x - centre.x, y, corner.y - centre.y);
      const float across =
          std::max(std::abs(glm::dot(offset, camera.right())) / aspect, std::abs(glm::dot(offset, camera.up())));
      // What lies nearer than the target looks larger in perspective.
      const float nearer = camera.orthographic ? 0.0f : -glm::dot(offset, camera.forward());
      distance = std::max(distance, kMargin * across / tangent + nearer);
    }
  }
  camera.distance = std::clamp(distance, kMinDistance, kMaxDistance);
  return camera;
}

}  // namespace windloom::editor
