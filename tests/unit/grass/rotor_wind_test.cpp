#include <gtest/gtest.h>

#include <cmath>

#include "engine/grass/rotors.hpp"

namespace windloom {
namespace {

constexpr float kSpeed = 16.0f, kRadius = 5.0f;

Rotor plainRotor() {
  Rotor rotor;
  rotor.id = 1;
  rotor.radius = kRadius;
  rotor.speed = kSpeed;
  rotor.lift = 0.0f;
  rotor.rings = 0.0f;
  return rotor;
}

glm::vec3 airOf(const Rotor& rotor, glm::vec2 place, float above = 0.0f, double seconds = 0.0) {
  return rotorAir(makeRotorBlock({rotor}, seconds), place, above);
}

TEST(RotorWind, RunsOutwardsFastestAtTheRimAndAsOneOverTheDistanceBeyond) {
  const Rotor rotor = plainRotor();
  EXPECT_EQ(glm::length(airOf(rotor, {0.0f, 0.0f})), 0.0f);
  EXPECT_NEAR(airOf(rotor, {kRadius, 0.0f}).x, kSpeed, 1e-3f);
  float most = 0.0f, at = 0.0f;
  for (float r = 0.1f; r < 40.0f; r += 0.1f) {
    const glm::vec3 air = airOf(rotor, {0.0f, r});
    EXPECT_GT(air.z, 0.0f);
    EXPECT_NEAR(air.x, 0.0f, 1e-6f);
    if (air.z > most) most = air.z, at = r;
  }
  EXPECT_NEAR(at, kRadius, 0.11f);
  const float near = airOf(rotor, {20.0f, 0.0f}).x, far = airOf(rotor, {40.0f, 0.0f}).x;
  EXPECT_NEAR(near / far, 2.0f, 0.1f);
}

TEST(RotorWind, ComesDownInsideAndNotThroughTheGround) {
  const Rotor rotor = plainRotor();
  EXPECT_EQ(airOf(rotor, {1.0f, 0.0f}).y, 0.0f);
  EXPECT_LT(airOf(rotor, {0.0f, 0.0f}, 4.0f).y, -0.7f * kSpeed);
  EXPECT_GT(airOf(rotor, {0.0f, 0.0f}, 100.0f).y, -kSpeed);
  EXPECT_GT(airOf(rotor, {4.0f * kRadius, 0.0f}, 1.0f).y, -0.01f * kSpeed);
}

TEST(RotorWind, IsFreeOfDivergenceNearTheGround) {
  const Rotor rotor = plainRotor();
  const float h = 0.02f;
  for (float r = 0.5f; r < 12.0f; r += 0.5f) {
    const glm::vec2 place(0.6f * r, 0.8f * r);
    const float dx = airOf(rotor, place + glm::vec2(h, 0.0f)).x - airOf(rotor, place - glm::vec2(h, 0.0f)).x;
    const float dz = airOf(rotor, place + glm::vec2(0.0f, h)).z - airOf(rotor, place - glm::vec2(0.0f, h)).z;
    const float dy = 2.0f * airOf(rotor, place, h).y;
    EXPECT_NEAR(dx + dy + dz, 0.0f, 0.03f * (std::abs(dx) + std::abs(dy) + std::abs(dz))) << r;
  }
}

TEST(RotorWind, WeakensWithLiftOverSeveralRadii) {
  Rotor rotor = plainRotor();
  const auto most = [&](float lift) {
    rotor.lift = lift;
    float found = 0.0f;
    for (float r = 0.5f; r < 40.0f; r += 0.5f) found = std::max(found, airOf(rotor, {r, 0.0f}).x);
    return found;
  };
  EXPECT_GT(most(kRadius), 0.95f * kSpeed);
  EXPECT_LT(most(4.0f * kRadius), 0.75f * kSpeed);
  EXPECT_LT(most(12.0f * kRadius), 0.4f * kSpeed);
}

TEST(RotorWind, RingsRunOutwardsAtTheirRate) {
  Rotor rotor = plainRotor();
  rotor.rings = 0.6f;
  rotor.rate = 0.8f;
  const glm::vec2 place(12.0f, 0.0f);
  const double period = 1.0 / 0.8;
  EXPECT_NEAR(airOf(rotor, place, 0.0f, 1.0).x, airOf(rotor, place, 0.0f, 1.0 + 4.0 * period).x, 1e-3f);
  float least = 1e9f, most = 0.0f;
  for (int i = 0; i < 40; ++i) {
    const float air = airOf(rotor, place, 0.0f, i * period / 40.0).x;
    least = std::min(least, air);
    most = std::max(most, air);
  }
  EXPECT_GT(most, 1.8f * least);
  // A quarter of a period later the same bump is so much farther out.
  const float way = static_cast<float>(0.25 * period) * 0.6f * kSpeed;
  const float plain = airOf(plainRotor(), place).x, plainLater = airOf(plainRotor(), place + glm::vec2(way, 0.0f)).x;
  EXPECT_NEAR(airOf(rotor, place, 0.0f, 2.0).x / plain,
              airOf(rotor, place + glm::vec2(way, 0.0f), 0.0f, 2.0 + 0.25 * period).x / plainLater, 1e-3f);
  // The same moment asked for ahead of time.
  const RotorBlock block = makeRotorBlock({rotor}, 2.0);
  EXPECT_NEAR(rotorAir(block, place, 0.2f, 0.4f).x, airOf(rotor, place, 0.2f, 2.4).x, 1e-3f);
}

TEST(RotorWind, StaysFiniteForRotorsThatHardlyBlow) {
  for (const float value : {0.0f, 1e-3f}) {
    Rotor rotor = plainRotor();
    rotor.speed = value;
    rotor.rate = value;
    rotor.rings = 1.0f;
    rotor.lift = 1000.0f;
    const glm::vec3 air = airOf(rotor, {3.0f, 4.0f}, 1.0f, 1e6);
    EXPECT_TRUE(std::isfinite(glm::length(air)));
    EXPECT_LT(glm::length(air), 0.01f);
  }
}

TEST(RotorWind, LeavesOutMutedRotorsAndThoseBeyondTheMost) {
  std::vector<Rotor> rotors(ROTOR_MOST + 4, plainRotor());
  rotors[0].muted = true;
  EXPECT_EQ(makeRotorBlock(rotors, 0.0).count.x, static_cast<float>(ROTOR_MOST));
  rotors.resize(3);
  EXPECT_EQ(makeRotorBlock(rotors, 0.0).count.x, 2.0f);
  EXPECT_EQ(makeRotorBlock({}, 0.0).count.x, 0.0f);
}

}  // namespace
}  // namespace windloom
