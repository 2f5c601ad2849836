#pragma once
// Belyaev's chain once more, plainly: rotation matrices in double precision, turns by the matrices' power series, tiny
// explicit steps. Shares no code with shaders/shared/segment_chain.h.

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "shaders/shared/segment_chain.h"

namespace windloom::testing {

using glm::dmat3;
using glm::dvec2;
using glm::dvec3;

/// exp of the matrix that crosses with v.
inline dmat3 turnMatrix(dvec3 v) {
  const dmat3 crossing(dvec3(0, v.z, -v.y), dvec3(-v.z, 0, v.x), dvec3(v.y, -v.x, 0));
  dmat3 sum(1.0), term(1.0);
  for (int n = 1; n < 40; ++n) {
    term = term * crossing / static_cast<double>(n);
    sum += term;
  }
  return sum;
}

inline dvec3 turnVector(const dmat3& m) {
  const dvec3 twice(m[1].z - m[2].y, m[2].x - m[0].z, m[0].y - m[1].x);
  const double angle = std::acos(std::clamp(0.5 * (m[0].x + m[1].y + m[2].z - 1.0), -1.0, 1.0));
  return std::sin(angle) < 1e-9 ? 0.5 * twice : twice * (0.5 * angle / std::sin(angle));
}

struct PlainChain {
  static constexpr std::size_t kSegments = 4;
  double stiffness = 0, damping = 0, weight = 0, halfLength = 0, drive = 0, exponent = 1;
  std::array<dmat3, kSegments> turns{dmat3(1.0), dmat3(1.0), dmat3(1.0), dmat3(1.0)};
  std::array<dvec3, kSegments> omegas{};

  explicit PlainChain(const shared::ChainBlock& block)
      : stiffness(static_cast<double>(block.spring.x)),
        damping(static_cast<double>(block.spring.y)),
        weight(static_cast<double>(block.spring.z)),
        halfLength(static_cast<double>(block.spring.w)),
        drive(static_cast<double>(block.wind.x)),
        exponent(static_cast<double>(block.wind.y)) {}

  static double share(std::size_t i) { return std::array{1.0 / 6.0, 0.5, 5.0 / 6.0, 1.0}[i]; }

  [[nodiscard]] double bend(double speed) const {
    const double x = drive * std::pow(speed, exponent);
    return x / std::hypot(1.0, x / 1.27);
  }

  /// l f / k of segment i: what holds it, with its weight, where arc would lean it.
  [[nodiscard]] double force(std::size_t i, double speed) const {
    const double lean = share(i) * bend(speed);
    const double own = std::array{1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0}[i] * bend(speed);
    return (own - weight * std::sin(lean)) / std::cos(lean);
  }

  /// Orientation of segment i after a long time in this wind.
  [[nodiscard]] dmat3 steadyFrame(std::size_t i, dvec3 wind) const {
    const double speed = glm::length(wind);
    if (speed < 1e-9) return dmat3(1.0);
    return turnMatrix(glm::cross(dvec3(0.0, 1.0, 0.0), wind / speed) * (share(i) * bend(speed)));
  }

  /// One explicit step.
  void step(dvec3 wind, double dt) {
    dmat3 below(1.0);
    dvec3 tipVelocity(0.0), tipAcceleration(0.0), turning(0.0), turningFaster(0.0);
    for (std::size_t i = 0; i < kSegments; ++i) {
      dvec3 centre = below * turns[i] * dvec3(0.0, halfLength, 0.0);
      const dvec3 carried = tipVelocity + glm::cross(turning, centre);
      const dvec3 velocity = carried + glm::cross(below * omegas[i], centre);
      const double speed = std::max(glm::length(wind - velocity), 1e-3);
      const double drag = stiffness * force(i, speed) / (halfLength * speed);
      const dvec3 up(0.0, 1.0, 0.0);
      const dvec3 axis = turns[i] * up;
      const dvec3 steadyUp = i == 0 ? up : glm::transpose(steadyFrame(i - 1, wind)) * up;
      const dvec3 ownWeight = -stiffness * weight * glm::cross(axis, steadyUp);
      const dvec3 carriedWeight = -stiffness * weight * glm::cross(axis, glm::transpose(below) * up) - ownWeight;
      const dvec3 push = glm::transpose(below) * glm::cross(centre, drag * wind) + ownWeight;
      const dvec3 lagging = -0.75 / (halfLength * halfLength) * tipAcceleration - drag * carried;
      const dvec3 carriedPush = glm::transpose(below) * glm::cross(centre, lagging) + carriedWeight;
      const double work = glm::dot(carriedPush, omegas[i]) / std::max(glm::dot(omegas[i], omegas[i]), 1e-8);
      const double own = damping + drag * halfLength * halfLength;
      const double loss = own - std::clamp(work, -0.5 * own, 0.5 * own);
      const dvec3 faster = push - stiffness * turnVector(turns[i]) - loss * omegas[i];
      omegas[i] += faster * dt;
      turns[i] = turnMatrix(omegas[i] * dt) * turns[i];
      centre = below * turns[i] * dvec3(0.0, halfLength, 0.0);
      turning += below * omegas[i];
      turningFaster += below * faster;
      tipVelocity += glm::cross(turning, 2.0 * centre);
      tipAcceleration += glm::cross(turningFaster, 2.0 * centre);
      below = below * turns[i];
    }
  }

  /// Unit vectors along the segments.
  [[nodiscard]] std::array<dvec3, kSegments> axes() const {
    std::array<dvec3, kSegments> found{};
    dmat3 frame(1.0);
    for (std::size_t i = 0; i < kSegments; ++i) {
      frame = frame * turns[i];
      found[i] = frame[1];
    }
    return found;
  }
};

}  // namespace windloom::testing
