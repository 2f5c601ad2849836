#pragma once
// A test with Bezier blades, their physics and what they find bound in a frame.

#include <optional>
#include <vector>

#include "tests/gpu/grass/bezier_blades.hpp"
#include "tests/gpu/grass/grass_fixture.hpp"

namespace windloom::testing {

class BezierTest : public GrassPassTest {
 protected:
  void SetUp() override {
    GrassPassTest::SetUp();
    m_scene->blow({0.0f, 0.0f});
    bezier.gravity = 0.0f;
    m_physics = physics();
  }
  void TearDown() override {
    m_physics.reset();
    GrassPassTest::TearDown();
  }

  std::optional<BezierPhysics> physics() { return taken(BezierPhysics::create(shaders())); }

  /// As the settings were at the last configure() or edit(): equal parts mean unchanged.
  [[nodiscard]] const Project& project() const { return m_project; }
  void edit() {
    m_project.bezier = std::make_shared<BezierSettings>(bezier);
    m_project.grass = std::make_shared<GrassSettings>(m_scene->grass);
    m_project.ambient = std::make_shared<AmbientWind>(m_scene->ambient);
    m_project.colliders = std::make_shared<std::vector<Collider>>(colliders);
  }
  void configure(const BladeStore& blades) {
    edit();
    const Status set = m_physics->configure(blades.store());
    ASSERT_TRUE(set.ok()) << set.error().text();
  }
  void advance(const BladeStore& blades, double seconds, bool quick = false) {
    advance(*m_physics, blades, seconds, quick);
  }
  void advance(BezierPhysics& physics, const BladeStore& blades, double seconds, bool quick = false) {
    m_scene->bindFrame(seconds);
    physics.advance(project(), blades.store(), seconds, quick);
  }

  BezierSettings bezier;
  std::optional<BezierPhysics> m_physics;
  std::vector<Collider> colliders;

 private:
  Project m_project;
};

}  // namespace windloom::testing
