#include "engine/grass/segment_chain.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <vector>

#include "tests/unit/grass/chain_fixture.hpp"

namespace windloom {
namespace {

using shared::arcAt;
using shared::arcSteadyBend;
using testing::axisOf;
using testing::difference;
using testing::dvec3;
using testing::energy;
using testing::forManyMeadows;
using testing::gust;
using testing::kSegments;
using testing::lowestPoint;
using testing::PlainChain;
using testing::randomState;
using testing::tipHeight;

TEST(ChainRotation, MatrixIsThePowerSeriesOfTheTurn) {
  std::mt19937 random(1);
  for (int n = 0; n < 200; ++n) {
    const glm::vec3 psi = randomState(random, 2.0f, 0.0f).psi[0] * (n < 20 ? 1e-3f : 1.0f);
    const glm::dmat3 wanted = testing::turnMatrix(dvec3(psi));
    const glm::mat3 got = shared::chainMatrix(psi);
    for (int c = 0; c < 3; ++c) EXPECT_LT(glm::length(glm::dvec3(got[c]) - wanted[c]), 1e-6) << n;
  }
}

TEST(ChainRotation, VectorUndoesTheMatrix) {
  std::mt19937 random(2);
  for (int n = 0; n < 200; ++n) {
    const glm::vec3 psi = randomState(random, n < 20 ? 1e-4f : 1.8f, 0.0f).psi[0];
    EXPECT_LT(glm::length(shared::chainVector(shared::chainMatrix(psi)) - psi), 2e-6f) << n;
  }
}

TEST(ChainRotation, TurnAndLeanAreTheSame) {
  for (const glm::vec2 lean :
       {glm::vec2(0.0f), glm::vec2(0.4f, 0.0f), glm::vec2(-0.3f, 1.2f), glm::vec2(0.0f, -2.0f)}) {
    const glm::vec3 axis = shared::chainMatrix(shared::chainTurn(lean))[1];
    EXPECT_LT(glm::length(axis - axisOf(lean)), 1e-6f);
    EXPECT_LT(glm::length(shared::chainLean(axis) - lean), 1e-5f);
  }
}

TEST(ChainSteady, SwingRateAndDampingAreThoseAskedFor) {
  GrassSettings grass;
  grass.windFactor = 0.0f;
  const ChainBlock chain = makeChainBlock(grass);
  ChainState state = shared::chainSteadyState(chain, {});
  state.psi[0] = {0.0f, 0.0f, -0.05f};  // the lowest joint is carried by nothing
  std::vector<float> peaks;
  std::vector<int> when;
  float before = 0.05f, last = 0.05f;
  for (int n = 0; n < 240 * 4; ++n) {
    state = shared::chainStep(chain, state, {}, 1.0f / 240.0f);
    const float now = -state.psi[0].z;
    if (last > before && last > now && last > 0.001f) {
      peaks.push_back(last);
      when.push_back(n);
    }
    before = last;
    last = now;
  }
  ASSERT_GE(peaks.size(), 2u);
  const float zeta = grass.swingDamping;
  const float damped = grass.swingRate * std::sqrt(1.0f - zeta * zeta);
  EXPECT_NEAR(240.0f / static_cast<float>(when[1] - when[0]), damped, 0.03f * damped);
  const float ratio = std::exp(-2.0f * std::numbers::pi_v<float> * zeta / std::sqrt(1.0f - zeta * zeta));
  EXPECT_NEAR(peaks[1] / peaks[0], ratio, 0.03f);
}

TEST(ChainSteady, LeansAsArcDoesForALinearWind) {
  GrassSettings grass;
  grass.windExponent = 1.0f;
  const ChainBlock chain = makeChainBlock(grass);
  for (int speed = 0; speed <= 40; ++speed) {
    const glm::vec2 wind(0.6f * static_cast<float>(speed), -0.8f * static_cast<float>(speed));
    const glm::vec2 bend = arcSteadyBend({}, wind, grass.windFactor / grass.stiffness);
    const ChainLeans leans = shared::chainSteadyLeans(chain, wind);
    for (int i = 0; i < kSegments; ++i) {
      const shared::ArcPoint point = arcAt(glm::length(bend), (static_cast<float>(i) + 0.5f) / kSegments);
      EXPECT_NEAR(glm::length(leans.e[i]), std::atan2(point.tangent.x, point.tangent.y), 2e-3f) << speed;
    }
    EXPECT_NEAR(tipHeight(leans), arcAt(glm::length(bend), 1.0f).position.y, 0.01f) << speed;
  }
}

TEST(ChainSteady, StaysCloseToArcForTheDefaultExponent) {
  const GrassSettings grass;
  const ChainBlock chain = makeChainBlock(grass);
  for (int speed = 0; speed <= 40; ++speed) {
    const glm::vec2 wind(static_cast<float>(speed), 0.0f);
    const float bend = arcSteadyBend({}, wind, grass.windFactor / grass.stiffness).x;
    EXPECT_NEAR(shared::chainSteadyLeans(chain, wind).e[3].x, bend, 0.082f) << speed;
  }
}

TEST(ChainSteady, NeverLiesDownAndLeansFurtherTheStrongerTheWind) {
  forManyMeadows([](const GrassSettings& grass) {
    const ChainBlock chain = makeChainBlock(grass);
    float before = -1.0f;
    for (int half = 0; half <= 80; ++half) {
      const ChainLeans leans = shared::chainSteadyLeans(chain, {0.5f * static_cast<float>(half), 0.0f});
      ASSERT_GE(tipHeight(leans), 0.15f);
      ASSERT_GE(lowestPoint(leans), 0.0f);
      const float lean = leans.e[3].x;
      const bool blown = grass.windFactor > 0.0f && lean < ARC_ANGLE_LIMIT - 1e-4f;
      if (blown)
        ASSERT_GT(lean, before) << "wind " << 0.5f * static_cast<float>(half);
      else
        ASSERT_GE(lean, before - 1e-6f);
      before = lean;
    }
  });
}

TEST(ChainSteady, IsWhereTheMotionComesToRest) {
  GrassSettings grass;
  grass.swingDamping = 0.6f;
  const ChainBlock chain = makeChainBlock(grass);
  for (const float speed : {0.0f, 1.0f, 6.0f, 15.0f, 40.0f}) {
    const glm::vec2 wind(0.8f * speed, 0.6f * speed);
    ChainState state = shared::chainSteadyState(chain, {-3.0f, 1.0f});
    for (int n = 0; n < 60 * 8; ++n) state = shared::chainStep(chain, state, wind, 1.0f / 60.0f);
    EXPECT_LT(difference(shared::chainLeans(state), shared::chainSteadyLeans(chain, wind)), 3e-3f) << speed;
  }
}

/// Leans every 0.1 s of 3 s through the gust, stepped at `rate` Hz.
std::vector<ChainLeans> throughGust(const GrassSettings& grass, int rate) {
  const ChainBlock chain = makeChainBlock(grass);
  ChainState state = shared::chainSteadyState(chain, gust(0.0));
  std::vector<ChainLeans> course;
  for (int n = 0; n < 3 * rate; ++n) {
    const double middle = (static_cast<double>(n) + 0.5) / rate;
    state = shared::chainStep(chain, state, gust(middle), 1.0f / static_cast<float>(rate));
    if ((n + 1) % (rate / 10) == 0) course.push_back(shared::chainLeans(state));
  }
  return course;
}

TEST(ChainMotion, FollowsThePlainModel) {
  const GrassSettings grass;
  const ChainBlock chain = makeChainBlock(grass);
  const std::vector<ChainLeans> course = throughGust(grass, 60);
  PlainChain plain(chain);
  const ChainState start = shared::chainSteadyState(chain, gust(0.0));
  for (std::size_t i = 0; i < 4; ++i) plain.turns[i] = testing::turnMatrix(dvec3(start.psi[i]));
  constexpr double kStep = 1.0 / 6000.0;
  std::size_t at = 0;
  for (int n = 0; n < 18000; ++n) {
    const glm::vec2 wind = gust((n + 0.5) * kStep);
    plain.step({static_cast<double>(wind.x), 0.0, static_cast<double>(wind.y)}, kStep);
    if ((n + 1) % 600 != 0) continue;
    const auto axes = plain.axes();
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_LT(glm::length(glm::vec3(axes[i]) - axisOf(course[at].e[i])), 0.03f) << "after " << n * kStep << " s";
    }
    ++at;
  }
}

TEST(ChainMotion, OneSmallStepIsThePlainModels) {
  // In a strong drive, where every term of the step counts.
  GrassSettings grass;
  grass.windFactor = 0.6f;
  const ChainBlock chain = makeChainBlock(grass);
  std::mt19937 random(21);
  constexpr float kStep = 1e-4f;
  for (int n = 0; n < 300; ++n) {
    ChainState state = randomState(random, 0.3f, 4.0f);
    PlainChain plain(chain);
    for (std::size_t i = 0; i < 4; ++i) {
      plain.turns[i] = testing::turnMatrix(dvec3(state.psi[i]));
      plain.omegas[i] = dvec3(state.omega[i]);
    }
    const glm::vec3 wind(n % 3 == 0 ? 0.0f : 6.0f, 0.0f, 2.0f);
    state = shared::chainPart(chain, state, wind, shared::chainSteadyLeans(chain, {wind.x, wind.z}), kStep);
    plain.step(dvec3(wind), static_cast<double>(kStep));
    for (int i = 0; i < kSegments; ++i) {
      const auto away = glm::length(plain.omegas[static_cast<std::size_t>(i)] - dvec3(state.omega[i]));
      EXPECT_LT(away / static_cast<double>(kStep * chain.spring.x), 0.01) << n << " segment " << i;
    }
  }
}

TEST(ChainMotion, IsTheSameAt30And60And240Hz) {
  for (const float damping : {0.05f, 0.18f, 0.7f}) {
    GrassSettings grass;
    grass.swingDamping = damping;
    const auto slow = throughGust(grass, 30), normal = throughGust(grass, 60), fast = throughGust(grass, 240);
    for (std::size_t i = 0; i < fast.size(); ++i) {
      EXPECT_LT(difference(slow[i], fast[i]), 0.03f) << damping << " at " << i;
      EXPECT_LT(difference(normal[i], fast[i]), 0.03f) << damping << " at " << i;
    }
  }
}

TEST(ChainMotion, StaysBoundedAtEveryStiffnessAndTimeStep) {
  forManyMeadows([](const GrassSettings& grass) {
    const ChainBlock chain = makeChainBlock(grass);
    for (const float dt : {1.0f / 60.0f, 0.1f}) {
      std::mt19937 random(5);
      std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
      ChainState state = shared::chainSteadyState(chain, {});
      for (int n = 0; n < 60; ++n) {
        const float top = n % 20 == 19 ? 100.0f : 15.0f;
        state = shared::chainStep(chain, state, {top * unit(random), top * unit(random)}, dt);
        for (int i = 0; i < kSegments; ++i) {
          ASSERT_TRUE(glm::length(state.psi[i]) < CHAIN_MOST_BEND + 1e-3f) << "step " << n << " dt " << dt;
          ASSERT_TRUE(std::isfinite(state.omega[i].x + state.omega[i].y + state.omega[i].z));
        }
      }
    }
  });
}

TEST(ChainMotion, NeverGainsEnergyWithoutWind) {
  forManyMeadows([](const GrassSettings& grass) {
    const ChainBlock chain = makeChainBlock(grass);
    for (const float dt : {1.0f / 240.0f, 1.0f / 60.0f, 0.1f}) {
      std::mt19937 random(9);
      ChainState state = randomState(random, 0.5f, 0.5f * std::sqrt(chain.spring.x));
      double before = energy(chain, state);
      for (int n = 0; n < 60; ++n) {
        state = shared::chainStep(chain, state, {}, dt);
        const double now = energy(chain, state);
        // The rest is what single precision makes of a state that hardly moves.
        ASSERT_LE(now, before * (1.0 + 1e-5) + 1e-9) << "step " << n << " dt " << dt;
        before = now;
      }
    }
  });
}

TEST(ChainMotion, LosesAllEnergyInTheEnd) {
  GrassSettings grass;
  grass.swingDamping = 0.02f;
  const ChainBlock chain = makeChainBlock(grass);
  for (unsigned seed = 0; seed < 10; ++seed) {
    std::mt19937 random(seed);
    ChainState state = randomState(random, 0.4f, 3.0f);
    const double start = energy(chain, state);
    for (int n = 0; n < 60 * 40; ++n) state = shared::chainStep(chain, state, {}, 1.0f / 60.0f);
    EXPECT_LT(energy(chain, state), 0.01 * start) << seed;
  }
}

TEST(ChainMotion, OvershootsAndSettlesAfterAGust) {
  const GrassSettings grass;
  const ChainBlock chain = makeChainBlock(grass);
  const glm::vec2 wind(6.0f, 0.0f);
  ChainState state = shared::chainSteadyState(chain, {});
  const float steady = shared::chainSteadyLeans(chain, wind).e[3].x;
  std::vector<float> course;
  for (int n = 0; n < 60 * 6; ++n) {
    state = shared::chainStep(chain, state, wind, 1.0f / 60.0f);
    course.push_back(shared::chainLeans(state).e[3].x);
  }
  const auto peak = std::max_element(course.begin(), course.end());
  EXPECT_GT(*peak, 1.2f * steady) << "it overshoots";
  EXPECT_LT(*peak, 1.8f * steady);
  EXPECT_LT(*std::min_element(peak, course.end()), 0.98f * steady) << "and swings back";
  EXPECT_NEAR(course.back(), steady, 0.01f * steady) << "and settles";
}

TEST(ChainMotion, NeverDipsBelowItsRootInAGust) {
  forManyMeadows([](const GrassSettings& grass) {
    if (grass.swingRate > 5.0f) return;
    const ChainBlock chain = makeChainBlock(grass);
    ChainState state = shared::chainSteadyState(chain, {});
    for (int n = 0; n < 120; ++n) {
      state = shared::chainStep(chain, state, {n < 60 ? 40.0f : 2.0f, 0.0f}, 1.0f / 60.0f);
      ASSERT_GE(lowestPoint(shared::chainLeans(state)), 0.0f) << n;
    }
  });
}

TEST(ChainSettled, TellsWhenASwingIsOver) {
  for (const float damping : {0.02f, 0.18f, 1.0f}) {
    GrassSettings grass;
    grass.swingDamping = damping;
    // The worst blade: slowest, let go lying flat.
    const float rate = 0.85f * 2.0f * std::numbers::pi_v<float> * grass.swingRate;
    const float dt = 1.0f / 240.0f, after = settledAfter(grass);
    glm::vec3 psi(0.0f, 0.0f, 0.5f * std::numbers::pi_v<float>), omega(0.0f);
    float largest = 0.0f, shortBefore = 0.0f;
    for (int n = 0; static_cast<float>(n) * dt < after + 3.0f; ++n) {
      const glm::vec3 mean =
          shared::chainMeanOmega(psi, omega, glm::vec3(0.0f), rate * rate, 2.0f * damping * rate, dt);
      omega = 2.0f * mean - omega;
      psi += mean * dt;
      const float time = static_cast<float>(n) * dt;
      if (time > after) largest = std::max(largest, std::abs(psi.z));
      if (time > 0.3f * after && time < 0.6f * after) shortBefore = std::max(shortBefore, std::abs(psi.z));
    }
    EXPECT_LT(largest * grass.height, 0.001f) << damping;
    EXPECT_GT(shortBefore * grass.height, 0.001f) << damping << ": not far too late";
  }
}

}  // namespace
}  // namespace windloom
