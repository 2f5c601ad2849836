#pragma once
// Random legal fields, solvers and arrows, most of them nasty.

#include <random>

#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {

class RandomSetup {
 public:
  explicit RandomSetup(int seed) : m_random(static_cast<unsigned>(seed)) {}

  WindSetup setup() {
    WindSetup s;
    s.field.resolution = {whole(8, 72), whole(8, 72)};
    s.field.size = {spread(1, 2000), one(3) ? spread(1, 2000) : 0.0f};
    if (s.field.size.y == 0)
      s.field.size.y = s.field.size.x * float(s.field.resolution.y) / float(s.field.resolution.x);
    s.field.centre = {between(-100, 100), between(-100, 100)};
    s.field.timeStep = one(3) ? spread(1e-4f, 0.25f) : 1.0f / 60;
    sides(s.field.xMin, s.field.xMax);
    sides(s.field.zMin, s.field.zMax);
    s.solver.advection = one(4) ? Advection::SemiLagrangian : Advection::MacCormack;
    s.solver.pressure = one(5) ? Pressure::Jacobi : Pressure::Multigrid;
    s.solver.divergenceTolerance = spread(1e-7f, 0.5f);
    s.solver.maxCycles = whole(1, 12);
    s.solver.jacobiSweeps = whole(1, 60);
    s.solver.confinement = one(2) ? between(0, 2) : 2.0f;
    s.solver.viscosity = one(3) ? spread(1e-4f, 100) : 0.0f;
    s.solver.dissipation = one(2) ? spread(1e-3f, 20) : 0.0f;
    s.solver.maxSpeed = one(3) ? spread(1, 340) : 100.0f;
    s.solver.seed = whole(0, 1000);
    s.ambient.speed = one(2) ? between(0, 60) : 0.0f;
    s.ambient.direction = between(-360, 360);
    s.ambient.gustStrength = one(2) ? between(0, 2) : 0.0f;
    s.ambient.gustSize = spread(0.5f, 10000);
    s.ambient.gustSpeed = between(0, 100);
    for (int n = one(2) ? whole(1, 6) : 0; n > 0; --n) s.obstacles.push_back(obstacle(s.field));
    return s;
  }

  ArrowForce force(const FieldSettings& field) {
    const float reach = std::max(field.size.x, field.size.y);
    const glm::vec2 from = place(field), to = from +
                                              glm::vec2(between(-1, 1), between(-1, 1)) * reach * spread(0.01f, 1) +
                                              glm::vec2(0.01f, 0);
    ArrowForce a = arrow(from, to, between(-100, 100), spread(0.05f, 1000));
    if (one(3)) a.from = a.to;
    a.drive = one(2) ? ARROW_DRIVE_FORCE : ARROW_DRIVE_SPEED;
    a.response = spread(0.01f, 60);
    a.swirl = one(3) ? between(-100, 100) : 0.0f;
    a.factor = between(0, 4);
    return a;
  }

  int whole(int low, int high) { return std::uniform_int_distribution(low, high)(m_random); }
  bool one(int in) { return whole(1, in) == 1; }

 private:
  float between(float low, float high) { return std::uniform_real_distribution(low, high)(m_random); }
  float spread(float low, float high) {
    return std::clamp(std::exp(between(std::log(low), std::log(high))), low, high);
  }
  glm::vec2 place(const FieldSettings& field) {
    return field.centre + field.size * glm::vec2(between(-0.7f, 0.7f), between(-0.7f, 0.7f));
  }
  void sides(Border& low, Border& high) {
    low = static_cast<Border>(whole(0, 2));
    high = low == Border::Periodic ? low : static_cast<Border>(whole(0, 1));
  }
  Obstacle obstacle(const FieldSettings& field) {
    Obstacle o;
    o.centre = place(field);
    o.shape = one(2) ? ObstacleShape::Box : ObstacleShape::Circle;
    o.radius = spread(0.01f, 0.4f) * field.size.x;
    o.size = field.size * glm::vec2(spread(0.01f, 0.8f), spread(0.01f, 0.8f));
    o.rotation = between(-360, 360);
    o.muted = one(8);
    return o;
  }
  std::mt19937 m_random;
};

}  // namespace windloom::testing
