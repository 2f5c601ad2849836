#pragma once
// A camera that orbits around a place over the field.

#include "maths.hpp"
#include "wind_source.hpp"

namespace game {

class Camera {
 public:
  /// Sees the whole field from beyond its near edge.
  explicit Camera(const Bounds& field)
      : m_target{(field.minX + field.maxX) / 2, 0, (field.minZ + field.maxZ) / 2},
        m_size(std::max(field.width(), field.depth())),
        m_distance(0.70f * m_size) {
    m_target.z += 0.05f * m_size;
    m_target.y = 0.025f * m_size;
  }

  void orbit(float yaw, float pitch) {
    m_yaw += yaw;
    m_pitch = std::clamp(m_pitch + pitch, 0.03f, 1.5f);
  }
  void zoom(float steps) { m_distance = std::clamp(m_distance * std::pow(0.9f, steps), 0.05f * m_size, 3 * m_size); }

  Vec3 eye() const {
    const Vec3 back{std::sin(m_yaw) * std::cos(m_pitch), std::sin(m_pitch), std::cos(m_yaw) * std::cos(m_pitch)};
    return m_target + back * m_distance;
  }
  Mat4 view() const { return lookAt(eye(), m_target); }
  Mat4 projection(float aspect) const { return perspective(kFieldOfView, aspect, 0.004f * m_size, 40 * m_size); }
  static constexpr float kFieldOfView = 0.72f;  ///< rad, from the lower to the upper edge of the picture

 private:
  Vec3 m_target;
  float m_size, m_distance;
  float m_yaw = -0.42f, m_pitch = 0.25f;  // rad
};

}  // namespace game
