#include "editor/core/navigation.hpp"

#include <algorithm>
#include <cmath>

namespace windloom::editor {
namespace {
constexpr float kShiftFactor = 4.0f;
constexpr float kSpeedPerNotch = 1.25f;
constexpr float kMinSpeed = 0.5f, kMaxSpeed = 400.0f;
constexpr float kPixelsPerNotch = 25.0f;  // Alt+RMB: a drag this long zooms as far as one wheel notch
}  // namespace

bool Navigator::press(const PointerEvent& pointer) {
  if (active()) return true;
  const Modifiers held = pointer.modifiers;
  Gesture gesture = Gesture::None;
  if (pointer.button == PointerButton::Middle) {
    gesture = held.shift || held.alt ? Gesture::Pan : held.ctrl ? Gesture::Zoom : Gesture::Orbit;
  } else if (pointer.button == PointerButton::Right) {
    gesture = held.alt ? Gesture::Zoom : Gesture::Fly;
  } else if (held.alt) {
    gesture = Gesture::Orbit;
  }
  if (gesture == Gesture::None) return false;
  m_gesture = gesture;
  m_button = pointer.button;
  m_last = m_start = pointer.pixel;
  m_held.clear();
  return true;
}

bool Navigator::move(EditorCamera& camera, const PointerEvent& pointer, glm::vec2 viewport, const Ground& ground) {
  if (!active()) return false;
  const glm::vec2 delta = pointer.pixel - m_last;
  m_last = pointer.pixel;
  switch (m_gesture) {
    case Gesture::Orbit:
      camera = orbit(camera, delta);
      break;
    case Gesture::Pan:
      camera = pan(camera, delta, viewport);
      break;
    case Gesture::Zoom:
      camera = zoomTo(camera, (delta.x - delta.y) / kPixelsPerNotch, m_start, viewport, ground);
      break;
    case Gesture::Fly:
      camera = lookAround(camera, delta);
      break;
    case Gesture::None:
      break;
  }
  return true;
}

bool Navigator::release(const PointerEvent& pointer) {
  if (!active() || pointer.button != m_button) return false;
  cancel();
  return true;
}

void Navigator::wheel(EditorCamera& camera, float notches, glm::vec2 pixel, glm::vec2 viewport, const Ground& ground) {
  if (flying()) {
    m_speedMps = std::clamp(m_speedMps * std::pow(kSpeedPerNotch, notches), kMinSpeed, kMaxSpeed);
  } else {
    camera = zoomTo(camera, notches, pixel, viewport, ground);
  }
}

bool Navigator::key(Key key, bool down) {
  if (!flying()) return false;
  const bool flies = key == Key::W || key == Key::A || key == Key::S || key == Key::D || key == Key::Q || key == Key::E;
  if (!flies) return false;
  if (down) {
    m_held.insert(key);
  } else {
    m_held.erase(key);
  }
  return true;
}

void Navigator::tick(EditorCamera& camera, double seconds, Modifiers held) {
  if (!flying() || m_held.empty()) return;
  const auto axis = [&](Key plus, Key minus) {
    return static_cast<float>(m_held.contains(plus)) - static_cast<float>(m_held.contains(minus));
  };
  const glm::vec3 direction(axis(Key::D, Key::A), axis(Key::E, Key::Q), axis(Key::W, Key::S));
  // A long hitch must not throw the camera across the field.
  const float time = static_cast<float>(std::min(seconds, 0.1));
  camera = fly(camera, direction, m_speedMps * (held.shift ? kShiftFactor : 1.0f), time);
}

void Navigator::cancel() {
  m_gesture = Gesture::None;
  m_held.clear();
}

}  // namespace windloom::editor
