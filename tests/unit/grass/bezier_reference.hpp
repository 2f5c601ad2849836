#pragma once
// Eq. 1 to 16 of Jahrmann & Wimmer, "Responsive real-time grass rendering", 2017, as printed, in double precision, and
// one blade stepped by them.

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <random>
#include <span>
#include <vector>

namespace windloom::testing::paper {

using dvec3 = glm::dvec3;

struct Blade {
  dvec3 root{0.0}, up{0.0, 1.0, 0.0}, front{1.0, 0.0, 0.0};
  double height = 1.0;
  double stiffness = 4.0;  // s
};

struct World {
  dvec3 direction{0.0, -1.0, 0.0};  // D_xyz
  double gravity = 0.0;             // D_w
  dvec3 centre{0.0};                // C_xyz
  double centreGravity = 0.0;       // C_w
  double blend = 0.0;               // t
  double frontPart = 0.25;
  dvec3 wind{0.0};    // w_i
  double fade = 0.5;  // a
};

struct Curve {
  dvec3 v1{0.0}, v2{0.0};  // from the root
};

inline double faded(double c, double a, double dt) {
  return std::max(c - a * dt, 0.0);
}  // 2

inline dvec3 recovery(const Blade& blade, dvec3 v2, double eta) {  // 3
  return (blade.up * blade.height - v2) * blade.stiffness * std::max(1.0 - eta, 0.1);
}

inline dvec3 gravity(const Blade& blade, const World& world) {  // 4-6
  const dvec3 to = world.centre - blade.root;
  dvec3 environment = world.direction / glm::length(world.direction) * world.gravity * (1.0 - world.blend);
  if (glm::length(to) > 0.0) environment += to / glm::length(to) * world.centreGravity * world.blend;
  return environment + world.frontPart * glm::length(environment) * blade.front;
}

inline double theta(const Blade& blade, dvec3 wind, dvec3 v2) {  // 7
  if (glm::length(wind) == 0.0 || glm::length(v2) == 0.0) return 0.0;
  const double fd = 1.0 - std::abs(glm::dot(wind / glm::length(wind), v2 / glm::length(v2)));
  const double fr = glm::dot(v2, blade.up) / blade.height;
  return fd * fr;
}

inline double length12(dvec3 v1, dvec3 v2) {  // 12
  const double n = 2.0, l0 = glm::length(v2), l1 = glm::length(v1) + glm::length(v2 - v1);
  return (2.0 * l0 + (n - 1.0) * l1) / (n + 1.0);
}

inline Curve valid(const Blade& blade, dvec3 v2) {
  v2 -= blade.up * std::min(glm::dot(blade.up, v2), 0.0);                    // 9
  const double lproj = glm::length(v2 - blade.up * glm::dot(v2, blade.up));  // 10
  const double part = lproj / blade.height;
  const dvec3 v1 = blade.height * blade.up * std::max(1.0 - part, 0.05 * std::max(part, 1.0));  // 11
  const double r = blade.height / length12(v1, v2);
  return {r * v1, r * v1 + r * (v2 - v1)};  // 13
}

inline dvec3 middle(const Blade& blade, Curve curve) {  // 14
  return 0.25 * blade.root + 0.5 * (blade.root + curve.v1) + 0.25 * (blade.root + curve.v2);
}

inline dvec3 translation(dvec3 c, double r, dvec3 p) {  // 15
  const double distance = glm::length(c - p);
  return std::min(distance - r, 0.0) * (c - p) / distance;
}

/// What moves the tip of a blade of its height, m/s: r + g + w.
inline dvec3 forces(const Blade& blade, const World& world, dvec3 v2, double eta) {
  return recovery(blade, v2, eta) + blade.height * (gravity(blade, world) + world.wind * theta(blade, world.wind, v2));
}

/// Eq. 1 and 9-13 for a moment without collisions.
inline dvec3 step(const Blade& blade, const World& world, dvec3 v2, double& eta, double dt) {
  eta = faded(eta, world.fade, dt);
  return valid(blade, v2 + forces(blade, world, v2, eta) * dt).v2;
}

/// The length of the curve itself.
inline double trueLength(Curve curve) {
  constexpr int kParts = 400;
  double sum = 0.0;
  for (int i = 0; i < kParts; ++i) {
    const double v = (i + 0.5) / kParts;
    sum += glm::length(2.0 * (1.0 - 2.0 * v) * curve.v1 + 2.0 * v * curve.v2) / kParts;
  }
  return sum;
}

inline dvec3 randomUnit(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return glm::normalize(dvec3(normal(random), normal(random), normal(random)));
}

}  // namespace windloom::testing::paper
