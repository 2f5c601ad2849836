#pragma once
// Small fields and measures that the tests of the solver share.

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "engine/wind/cpu_solver.hpp"

namespace windloom::testing {

inline constexpr double kPi = std::numbers::pi;

/// A field of `cells` with cells of `cellSizeM`, the same border on all sides, its low corner at (0, 0), and a
/// solver that adds nothing: no confinement, no dissipation.
inline WindSetup bareSetup(glm::ivec2 cells, float cellSizeM, Border border, float dt) {
  WindSetup setup;
  setup.field.resolution = cells;
  setup.field.size = glm::vec2(cells) * cellSizeM;
  setup.field.centre = setup.field.size / 2.0f;
  setup.field.xMin = setup.field.xMax = setup.field.zMin = setup.field.zMax = border;
  setup.field.timeStep = dt;
  setup.solver.confinement = 0;
  setup.solver.dissipation = 0;
  return setup;
}

/// Sets the faces from a velocity in the world and stops blocked ones; ghosts and cell velocities are the solver's job,
/// so this goes through setVelocity first.
inline void setFaces(CpuWindSolver& solver, const std::function<glm::dvec2(double x, double z)>& velocity) {
  CpuFields& f = solver.fields();
  const std::vector<glm::vec2> still(static_cast<std::size_t>(f.width()) * static_cast<std::size_t>(f.height()),
                                     glm::vec2(0));
  (void)solver.setVelocity(still);
  const glm::dvec2 low(f.grid.mapping.minCorner), h(f.grid.mapping.cellSize);
  for (int k = 0; k < f.height(); ++k) {
    for (int i = 0; i <= f.width(); ++i) {
      f.velocity.u.at(i, k) =
          f.grid.blockedX(i, k) ? 0.0f : static_cast<float>(velocity(low.x + i * h.x, low.y + (k + 0.5) * h.y).x);
    }
  }
  for (int k = 0; k <= f.height(); ++k) {
    for (int i = 0; i < f.width(); ++i) {
      f.velocity.w.at(i, k) =
          f.grid.blockedZ(i, k) ? 0.0f : static_cast<float>(velocity(low.x + (i + 0.5) * h.x, low.y + k * h.y).y);
    }
  }
}

/// Steady vortices with this many half waves across a square of `size` m and the given peak speed.
inline std::function<glm::dvec2(double, double)> taylorGreen(double size, double halfWaves, double peak) {
  return [=](double x, double z) {
    const double k = kPi * halfWaves / size;
    return glm::dvec2(peak * std::sin(k * x) * std::cos(k * z), -peak * std::cos(k * x) * std::sin(k * z));
  };
}

/// Sum over all faces of u^2 + w^2.
inline double faceEnergy(const CpuFields& f) {
  double sum = 0;
  for (int k = 0; k < f.height(); ++k) {
    for (int i = 0; i < f.width(); ++i)
      sum += std::pow(double(f.velocity.u.at(i, k)), 2) + std::pow(double(f.velocity.w.at(i, k)), 2);
  }
  return sum;
}

/// A straight drive along the arrow at full signal.
inline ArrowForce arrow(glm::vec2 from, glm::vec2 to, float strength, float radius) {
  ArrowForce a{};
  a.from = from;
  a.to = to;
  a.direction = glm::normalize(to - from);
  a.radius = radius;
  a.strength = strength;
  a.response = 0.25f;
  a.drive = ARROW_DRIVE_SPEED;
  a.factor = 1;
  return a;
}

inline void run(WindSolver& solver, int steps, std::span<const ArrowForce> arrows = {}, double dt = 1.0 / 60) {
  for (int n = 0; n < steps; ++n) solver.step(arrows, n * dt);
}

}  // namespace windloom::testing
