#pragma once
// The editor's view as a value: where it looks from, how gestures move it, and how pixels and the world
// map to each other. Pixels have their origin at the top left of the viewport, y down. Metres, +Y up.

#include <glm/glm.hpp>
#include <optional>

#include "editor/core/ground.hpp"

namespace windloom::editor {

enum class ViewDirection { Top, Front, Side };

/// Plain camera data for the renderer.
struct CameraPose {
  glm::vec3 position{0.0f};
  glm::vec3 target{0.0f};
  glm::vec3 up{0.0f, 1.0f, 0.0f};
  float fieldOfView = 45.0f;  ///< deg, vertical
  bool orthographic = false;
  float orthographicHeight = 100.0f;  ///< m over the viewport's height
  float nearPlane = 0.1f, farPlane = 2000.0f;
};

/// A camera that orbits `target`. At yaw 0 it looks along -Z (right is +X); positive yaw turns it towards +X
/// around the target; pitch 90 looks straight down with -Z (at yaw 0) up on the screen.
struct EditorCamera {
  glm::vec3 target{0.0f};
  float yaw = 30.0f;          ///< deg
  float pitch = 35.0f;        ///< deg, -89..90; 90 looks straight down
  float distance = 75.0f;     ///< m from the target
  float fieldOfView = 45.0f;  ///< deg, vertical
  bool orthographic = false;  ///< shows as much at the target as the perspective would

  [[nodiscard]] glm::vec3 position() const;
  [[nodiscard]] glm::vec3 forward() const;  ///< unit
  [[nodiscard]] glm::vec3 right() const;
  [[nodiscard]] glm::vec3 up() const;
  [[nodiscard]] CameraPose pose() const;
};

/// A camera in a viewport of `size` pixels: everything that maps between the two.
class ViewMapping {
 public:
  ViewMapping(const EditorCamera& camera, glm::vec2 size);

  [[nodiscard]] glm::vec2 size() const { return m_size; }
  [[nodiscard]] const EditorCamera& camera() const { return m_camera; }
  [[nodiscard]] Ray ray(glm::vec2 pixel) const;
  /// Nothing where the place is behind the camera.
  [[nodiscard]] std::optional<glm::vec2> toScreen(glm::vec3 world) const;
  /// Where the ray through the pixel meets the ground, at most 4 km away; (x, z).
  [[nodiscard]] std::optional<glm::vec2> toGround(glm::vec2 pixel, const Ground& ground) const;
  /// A ground position lifted onto the ground, on the screen.
  [[nodiscard]] std::optional<glm::vec2> groundToScreen(glm::vec2 world, const Ground& ground) const;
  /// How many metres a pixel covers at a place (perpendicular to the view).
  [[nodiscard]] float metresPerPixel(glm::vec3 world) const;

 private:
  EditorCamera m_camera;
  glm::vec2 m_size;
  glm::vec3 m_position, m_forward, m_right, m_up;
  float m_focal;  // pixels per unit of tangent, or per metre where orthographic
};

// Gestures. Each takes a camera and gives the moved one.

/// Turns around the target; `delta` in pixels.
EditorCamera orbit(EditorCamera camera, glm::vec2 delta);
/// Shifts so that what lies at the target's depth follows the pointer.
EditorCamera pan(EditorCamera camera, glm::vec2 delta, glm::vec2 viewport);
/// `notches` > 0 moves nearer; the ground under `pixel` stays under it. Distance is kept within 0.5..3000 m.
EditorCamera zoomTo(EditorCamera camera, float notches, glm::vec2 pixel, glm::vec2 viewport, const Ground& ground);
/// Looks around from where the camera stands; `delta` in pixels.
EditorCamera lookAround(EditorCamera camera, glm::vec2 delta);
/// Moves by `move` (right, up, forward; each -1..1) at `metresPerSecond` for `seconds`.
EditorCamera fly(EditorCamera camera, glm::vec3 move, float metresPerSecond, float seconds);
/// Orthographic along an axis; keeps target and distance.
EditorCamera lookAlong(EditorCamera camera, ViewDirection direction);
/// Shows the box given by two ground corners with a margin; on uneven ground with the hills in it.
EditorCamera frameBounds(EditorCamera camera, glm::vec2 low, glm::vec2 high, glm::vec2 viewport, const Ground& ground = {});

}  // namespace windloom::editor
