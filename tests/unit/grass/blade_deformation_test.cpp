#include "shaders/shared/blade_deformation.h"

#include <gtest/gtest.h>

#include <numbers>

namespace windloom {
namespace {

using shared::arcAt;
using shared::arcFlutter;
using shared::ArcPoint;
using shared::arcSteadyBend;
using shared::quadraticAt;

constexpr float kFactor = 0.06f;  // s/m: F of the default grass
constexpr int kNearSegments = 6;  // of the nearest level of detail

/// The bend of a blade at a moment: rest pose, wind, own phase and pace.
struct Blade {
  glm::vec2 rest{0.0f};
  glm::vec2 wind{0.0f};
  float phase = 0.0f, pace = 1.0f, flutter = 1.0f;

  [[nodiscard]] glm::vec2 bend(float time) const {
    return arcSteadyBend(rest, wind, kFactor) + arcFlutter(wind, time, phase, pace, flutter);
  }
};

/// Calls `body(blade, time)` for winds of 0 to 40 m/s, rest poses with, against and across the wind, and moments of
/// its flutter.
template <class Body>
void forManyBlades(Body body) {
  for (int speed = 0; speed <= 40; ++speed) {
    for (const glm::vec2 rest : {glm::vec2(0.0f), glm::vec2(0.7f, 0.0f), glm::vec2(-0.7f, 0.0f), glm::vec2(0.2f, 0.6f)}) {
      for (int phase = 0; phase < 5; ++phase) {
        const Blade blade{rest, {static_cast<float>(speed), 0.0f}, static_cast<float>(phase) / 5.0f, 0.8f + 0.1f * static_cast<float>(phase), 1.0f};
        for (int moment = 0; moment < 40; ++moment) body(blade, 0.11f * static_cast<float>(moment));
      }
    }
  }
}

float lengthAsDrawn(float angle, int segments) {
  float length = 0.0f;
  for (int i = 0; i < segments; ++i) {
    const auto at = [&](int row) { return arcAt(angle, static_cast<float>(row) / static_cast<float>(segments)).position; };
    length += glm::length(at(i + 1) - at(i));
  }
  return length;
}

/// Mean over time of how far the chord leans towards the wind, rad.
float meanTilt(const Blade& blade) {
  float sum = 0.0f;
  constexpr int kMoments = 4000;
  for (int i = 0; i < kMoments; ++i) {
    const glm::vec2 bend = blade.bend(0.017f * static_cast<float>(i));
    const float angle = glm::length(bend);
    const ArcPoint tip = arcAt(angle, 1.0f);
    const float along = angle > 0.0f ? tip.position.x * bend.x / angle : 0.0f;
    sum += std::atan2(along, tip.position.y);
  }
  return sum / static_cast<float>(kMoments);
}

TEST(BladeArc, KeepsItsLengthInEveryWind) {
  forManyBlades([](const Blade& blade, float time) {
    const float angle = glm::length(blade.bend(time));
    ASSERT_NEAR(lengthAsDrawn(angle, 400), 1.0f, 0.001f) << "wind " << blade.wind.x;
    ASSERT_NEAR(lengthAsDrawn(angle, kNearSegments), 1.0f, 0.01f) << "wind " << blade.wind.x;
  });
}

TEST(BladeArc, NeverGoesBelowItsRoot) {
  forManyBlades([](const Blade& blade, float time) {
    const float angle = glm::length(blade.bend(time));
    for (int i = 0; i <= 20; ++i) ASSERT_GE(arcAt(angle, static_cast<float>(i) / 20.0f).position.y, 0.0f) << "wind " << blade.wind.x;
  });
}

TEST(BladeArc, KeepsItsTipAboveFifteenPercentOfItsHeight) {
  forManyBlades([](const Blade& blade, float time) {
    ASSERT_GE(arcAt(glm::length(blade.bend(time)), 1.0f).position.y, 0.15f) << "wind " << blade.wind.x;
  });
}

TEST(BladeArc, NeverTurnsItsTipBelowTheHorizon) {
  forManyBlades([](const Blade& blade, float time) {
    ASSERT_LT(glm::length(blade.bend(time)), 0.5f * std::numbers::pi_v<float>) << "wind " << blade.wind.x;
  });
}

TEST(BladeArc, LeansFurtherTheStrongerTheWind) {
  for (const glm::vec2 rest : {glm::vec2(0.0f), glm::vec2(0.3f, 0.0f), glm::vec2(-0.3f, 0.1f), glm::vec2(0.0f, 0.5f)}) {
    float before = -10.0f;
    for (int half = 0; half <= 80; ++half) {
      const float tilt = meanTilt({rest, {0.5f * static_cast<float>(half), 0.0f}, 0.3f, 1.0f, 0.35f});
      ASSERT_GT(tilt, before) << "wind " << 0.5f * static_cast<float>(half) << " rest " << rest.x << ", " << rest.y;
      before = tilt;
    }
  }
}

TEST(BladeArc, KeepsFlutteringInAGale) {
  for (const float speed : {2.0f, 10.0f, 25.0f, 40.0f}) {
    const Blade blade{{0.1f, 0.0f}, {speed, 0.0f}, 0.2f, 1.0f, 0.35f};
    float low = 10.0f, high = -10.0f;
    for (int i = 0; i < 300; ++i) {
      const float angle = glm::length(blade.bend(0.02f * static_cast<float>(i)));
      low = std::min(low, angle);
      high = std::max(high, angle);
    }
    EXPECT_GT(high - low, glm::radians(1.5f)) << speed;
  }
}

TEST(BladeArc, StandsStillInStillAir) {
  const Blade blade{{0.2f, 0.1f}, {0.0f, 0.0f}, 0.2f, 1.0f, 1.0f};
  EXPECT_EQ(blade.bend(0.3f), blade.bend(7.7f));
}

TEST(BladeArc, LeavesItsRootUpright) {
  for (const float angle : {0.0f, 0.3f, 1.5f}) {
    EXPECT_EQ(arcAt(angle, 0.0f).position, glm::vec2(0.0f));
    EXPECT_EQ(arcAt(angle, 0.0f).tangent, glm::vec2(0.0f, 1.0f));
  }
}

TEST(BladeArc, MovesItsTipAsThePaperDoesInAWeakWind) {
  const float wind = 0.5f;
  const ArcPoint tip = arcAt(glm::length(arcSteadyBend({0.0f, 0.0f}, {wind, 0.0f}, kFactor)), 1.0f);
  EXPECT_NEAR(tip.position.x, kFactor * wind, 0.02f * kFactor * wind);
}

TEST(BladeArc, BendsAlongTheWind) {
  const glm::vec2 bend = arcSteadyBend({0.0f, 0.0f}, {3.0f, -4.0f}, kFactor);
  EXPECT_NEAR(bend.x / bend.y, -0.75f, 1e-5f);
}

TEST(BladeQuadratic, FollowsTheEquationsOfThePaper) {
  const float k1 = 0.05f, k2 = 0.1f, lambda = 0.2f;
  // Still air: lambda times the drooped blade.
  const glm::vec3 still = quadraticAt({0.01f, 1.0f, 0.0f}, {0.0f, 0.0f}, k1, k2, lambda);
  EXPECT_NEAR(still.x, 0.2f * 0.01f, 1e-6f);
  EXPECT_NEAR(still.y, 0.2f * 0.95f, 1e-6f);
  EXPECT_NEAR(still.z, 0.2f * 0.1f, 1e-6f);
  // F V = (0.3, -0.4), |F V| = 0.5, at half the height: P'_y = 0.5 - 0.05 / 4.
  const float y = 0.5f - 0.05f * 0.25f;
  const glm::vec3 blown = quadraticAt({0.0f, 0.5f, 0.0f}, {0.3f, -0.4f}, k1, k2, lambda);
  EXPECT_NEAR(blown.x, 0.8f * 0.3f * y * y, 1e-6f);
  EXPECT_NEAR(blown.y, 0.8f * -0.5f * y * y + 0.2f * y, 1e-6f);
  EXPECT_NEAR(blown.z, 0.8f * -0.4f * y * y + 0.2f * 0.1f * 0.25f, 1e-6f);
}

}  // namespace
}  // namespace windloom
