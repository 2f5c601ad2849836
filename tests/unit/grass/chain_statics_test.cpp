#include <gtest/gtest.h>

#include "tests/unit/grass/chain_fixture.hpp"

namespace windloom {
namespace {

using shared::arcSteadyBend;
using testing::axisOf;
using testing::difference;
using testing::dvec3;
using testing::gust;
using testing::kSegments;
using testing::lowestPoint;
using testing::randomState;
using testing::tipHeight;

TEST(ChainStatics, MomentsAreThoseOfTheReference) {
  // G_i = k psi_i - (0, l, 0) x T_i^T m g, with full matrices. A lean is a rotation vector of the world, so the two are
  // the same for chains in a plane and close to it for others.
  const ChainBlock chain = makeChainBlock({});
  std::mt19937 random(3);
  for (int n = 0; n < 60; ++n) {
    ChainState state = randomState(random, n < 30 ? 0.3f : 0.25f, 0.0f);
    const glm::vec3 level = glm::normalize(glm::vec3(state.psi[0].x, 0.0f, state.psi[0].z));
    if (n < 30) {
      for (glm::vec3& psi : state.psi) psi = level * psi.x;
    } else {
      for (glm::vec3& psi : state.psi) psi.y = 0.0f;
    }
    const ChainLeans moments = shared::chainMoments(chain, shared::chainLeans(state));
    glm::dmat3 frame(1.0);
    for (int i = 0; i < kSegments; ++i) {
      frame = frame * testing::turnMatrix(dvec3(state.psi[i]));
      const dvec3 down = glm::transpose(frame) * dvec3(0.0, -1.0, 0.0);
      const dvec3 wanted =
          dvec3(state.psi[i]) - static_cast<double>(chain.spring.z) * glm::cross(dvec3(0.0, 1.0, 0.0), down);
      const dvec3 got(shared::chainTurn(moments.e[i]));
      EXPECT_LT(glm::length(got - wanted), n < 30 ? 1e-5 : 0.12) << n << " segment " << i;
    }
  }
}

TEST(ChainStatics, ThreeIterationsFindTheEquilibriumOfTheReference) {
  // psi_i = (G_i + (0, l, 0) x T_i^T m g) / k, with full matrices and many iterations.
  const ChainBlock chain = makeChainBlock({});
  for (const float size : {0.1f, 0.3f, 0.45f}) {
    ChainLeans moments;
    for (glm::vec2& moment : moments.e) moment = size * glm::vec2(0.6f, -0.8f);
    const ChainLeans leans = shared::chainEquilibrium(chain, moments, {}, {1.0f, 0.0f});
    glm::dmat3 below(1.0);
    for (int i = 0; i < kSegments; ++i) {
      const dvec3 held(shared::chainTurn(moments.e[i]));
      dvec3 psi = held;
      for (int n = 0; n < 60; ++n) {
        const dvec3 down = glm::transpose(below * testing::turnMatrix(psi)) * dvec3(0.0, -1.0, 0.0);
        psi = held + static_cast<double>(chain.spring.z) * glm::cross(dvec3(0.0, 1.0, 0.0), down);
      }
      below = below * testing::turnMatrix(psi);
      EXPECT_LT(glm::length(glm::vec3(below[1]) - axisOf(leans.e[i])), 5e-4f) << size << " segment " << i;
    }
  }
}

TEST(ChainStatics, MomentsOfAMovingBladeHoldItWhereItIs) {
  const GrassSettings grass;
  const ChainBlock chain = makeChainBlock(grass);
  ChainState state = shared::chainSteadyState(chain, {});
  for (int n = 0; n < 180; ++n) {
    state = shared::chainStep(chain, state, gust(static_cast<double>(n) / 60.0), 1.0f / 60.0f);
    const ChainLeans leans = shared::chainLeans(state);
    const ChainLeans held = shared::chainEquilibrium(chain, shared::chainMoments(chain, leans), {}, {1.0f, 0.0f});
    ASSERT_LT(difference(leans, held), 1e-3f) << n;
  }
}

TEST(ChainStatics, SofterAndLeaningBladesBendAsArcWouldBendThem) {
  GrassSettings grass;
  grass.windExponent = 1.0f;
  const ChainBlock chain = makeChainBlock(grass);
  for (int speed = 0; speed <= 40; ++speed) {
    const glm::vec2 wind(static_cast<float>(speed), 0.0f);
    const ChainLeans moments = shared::chainMoments(chain, shared::chainSteadyLeans(chain, wind));
    for (const float relative : {0.6f, 1.0f, 1.6f, 4.0f}) {
      for (const glm::vec2 droop :
           {glm::vec2(0.0f), glm::vec2(0.7f, 0.0f), glm::vec2(-0.7f, 0.0f), glm::vec2(0.2f, 0.6f)}) {
        const glm::vec2 rest = arcSteadyBend(droop, {}, 1.0f);
        const glm::vec2 softness = shared::chainSoftness(chain, moments, rest, relative);
        const ChainLeans leans = shared::chainEquilibrium(chain, moments, rest, softness);
        const glm::vec2 arc = arcSteadyBend(droop, wind, relative * chain.wind.w);
        ASSERT_LT(glm::length(rest + leans.e[3] - arc), 0.09f) << speed << " m/s, " << relative;
        ChainLeans whole = leans;
        for (int i = 0; i < kSegments; ++i) whole.e[i] += rest * shared::chainShare(i);
        ASSERT_GE(tipHeight(whole), 0.15f) << speed << " m/s, " << relative;
        ASSERT_GE(lowestPoint(whole), 0.0f) << speed << " m/s, " << relative;
      }
    }
  }
}

TEST(ChainStatics, BladesStandAsAtRestInStillAir) {
  const ChainBlock chain = makeChainBlock({});
  const ChainLeans still = shared::chainMoments(chain, shared::chainSteadyLeans(chain, {}));
  const ChainLeans leans =
      shared::chainEquilibrium(chain, still, {0.5f, -0.3f}, shared::chainSoftness(chain, still, {0.5f, -0.3f}, 1.2f));
  for (const glm::vec2 lean : leans.e) EXPECT_LT(glm::length(lean), 1e-5f);
}

}  // namespace
}  // namespace windloom
