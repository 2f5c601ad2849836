#pragma once
// As much vector arithmetic as this game needs. Your game has its own; nothing here belongs to Windloom.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace game {

inline constexpr float kPi = 3.14159265f;

struct Vec2 {
  float x = 0, z = 0;  ///< over the ground, as Windloom's wind is
};

struct Vec3 {
  float x = 0, y = 0, z = 0;  ///< m; +Y up, right-handed
};

inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator*(Vec3 a, float s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Vec3& operator+=(Vec3& a, Vec3 b) {
  return a = a + b;
}
inline float dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline float length(Vec3 a) {
  return std::sqrt(dot(a, a));
}
inline float length(Vec2 a) {
  return std::sqrt(a.x * a.x + a.z * a.z);
}
/// `otherwise` where the vector has no direction.
inline Vec3 normalized(Vec3 a, Vec3 otherwise = {0, 1, 0}) {
  const float size = length(a);
  return size > 1e-6f ? a * (1 / size) : otherwise;
}
inline float mix(float a, float b, float part) {
  return a + (b - a) * part;
}
inline Vec3 mix(Vec3 a, Vec3 b, float part) {
  return a + (b - a) * part;
}

struct Quaternion {
  float x = 0, y = 0, z = 0, w = 1;
};

inline Quaternion operator*(const Quaternion& a, const Quaternion& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

/// First roll about z, then pitch about x, then yaw about y; radians.
inline Quaternion turned(float yaw, float pitch, float roll) {
  const Quaternion about_y{0, std::sin(yaw / 2), 0, std::cos(yaw / 2)};
  const Quaternion about_x{std::sin(pitch / 2), 0, 0, std::cos(pitch / 2)};
  const Quaternion about_z{0, 0, std::sin(roll / 2), std::cos(roll / 2)};
  return about_y * about_x * about_z;
}

using Mat4 = std::array<float, 16>;  ///< column after column, as OpenGL takes it

inline Mat4 operator*(const Mat4& a, const Mat4& b) {
  Mat4 product{};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      for (int k = 0; k < 4; ++k) product[column * 4 + row] += a[k * 4 + row] * b[column * 4 + k];
    }
  }
  return product;
}

/// `fieldOfView` in radians from the lower to the upper edge.
inline Mat4 perspective(float fieldOfView, float aspect, float near, float far) {
  const float focal = 1 / std::tan(fieldOfView / 2);
  return {focal / aspect,
          0,
          0,
          0,
          0,
          focal,
          0,
          0,
          0,
          0,
          (far + near) / (near - far),
          -1,
          0,
          0,
          2 * far * near / (near - far),
          0};
}

inline Mat4 lookAt(Vec3 eye, Vec3 target) {
  const Vec3 back = normalized(eye - target);
  const Vec3 right = normalized(cross({0, 1, 0}, back), {1, 0, 0});
  const Vec3 up = cross(back, right);
  return {right.x, up.x, back.x, 0, right.y,          up.y,          back.y,          0,
          right.z, up.z, back.z, 0, -dot(right, eye), -dot(up, eye), -dot(back, eye), 1};
}

/// The same numbers from the same seed on every machine, which std::uniform_real_distribution doesn't promise.
class Random {
 public:
  explicit Random(std::uint32_t seed) : m_state(seed * 2654435761u + 1013904223u) {}
  float unit() {  ///< 0 up to 1
    m_state ^= m_state << 13;
    m_state ^= m_state >> 17;
    m_state ^= m_state << 5;
    if (m_state == 0) m_state = 1;
    return static_cast<float>(m_state >> 8) * (1.0f / 16777216.0f);
  }
  float between(float low, float high) { return low + (high - low) * unit(); }

 private:
  std::uint32_t m_state;
};

}  // namespace game
