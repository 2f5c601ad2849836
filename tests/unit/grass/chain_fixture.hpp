#pragma once
// What the tests of the segment chain share.

#include <cmath>
#include <random>

#include "engine/grass/segment_chain.hpp"
#include "tests/unit/grass/chain_reference.hpp"

namespace windloom::testing {

inline constexpr int kSegments = CHAIN_SEGMENTS;

inline glm::vec3 axisOf(glm::vec2 lean) {
  const float angle = glm::length(lean);
  if (angle < 1e-7f) return {0.0f, 1.0f, 0.0f};
  const glm::vec2 level = lean * (std::sin(angle) / angle);
  return {level.x, std::cos(angle), level.y};
}

/// Height of the chain's end over its length.
inline float tipHeight(const ChainLeans& leans) {
  float sum = 0.0f;
  for (const glm::vec2 lean : leans.e) sum += axisOf(lean).y;
  return sum / static_cast<float>(kSegments);
}

inline float lowestPoint(const ChainLeans& leans) {
  float height = 0.0f, lowest = 0.0f;
  for (const glm::vec2 lean : leans.e) lowest = std::min(lowest, height += axisOf(lean).y);
  return lowest;
}

inline float difference(const ChainLeans& a, const ChainLeans& b) {
  float most = 0.0f;
  for (int i = 0; i < kSegments; ++i) most = std::max(most, glm::length(a.e[i] - b.e[i]));
  return most;
}

/// Energy over J: motion, springs, and each segment's height over its joint as its frame sees it.
inline double energy(const ChainBlock& chain, const ChainState& state) {
  const double stiffness = static_cast<double>(chain.spring.x),
               weight = stiffness * static_cast<double>(chain.spring.z);
  double sum = 0.0;
  for (int i = 0; i < kSegments; ++i) {
    const dvec3 psi(state.psi[i]), omega(state.omega[i]);
    sum += 0.5 * glm::dot(omega, omega) + 0.5 * stiffness * glm::dot(psi, psi);
    sum -= weight * (1.0 - testing::turnMatrix(psi)[1].y);
  }
  return sum;
}

inline ChainState randomState(std::mt19937& random, float psi, float omega) {
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  ChainState state;
  for (int i = 0; i < kSegments; ++i) {
    state.psi[i] = psi * glm::vec3(unit(random), 0.2f * unit(random), unit(random));
    state.omega[i] = omega * glm::vec3(unit(random), 0.2f * unit(random), unit(random));
  }
  return state;
}

/// Every stiffness, drive, exponent and swing that the editor allows, at their ends and between.
template <class Body>
void forManyMeadows(Body body) {
  for (const float stiffness : {0.05f, 1.0f, 20.0f}) {
    for (const float windFactor : {0.0f, 0.06f, 1.0f}) {
      for (const float exponent : {1.0f, 4.0f / 3.0f, 2.0f}) {
        for (const float rate : {0.1f, 1.4f, 20.0f}) {
          for (const float damping : {0.02f, 0.18f, 1.0f}) {
            GrassSettings grass;
            grass.stiffness = stiffness;
            grass.windFactor = windFactor;
            grass.windExponent = exponent;
            grass.swingRate = rate;
            grass.swingDamping = damping;
            body(grass);
          }
        }
      }
    }
  }
}

/// A gust that comes, turns and goes.
inline glm::vec2 gust(double time) {
  if (time < 0.2) return {2.0f, 0.0f};
  if (time < 1.1) return {12.0f, 0.0f};
  if (time < 1.8) return {5.0f, 9.0f};
  return {1.0f, 0.5f};
}

}  // namespace windloom::testing
