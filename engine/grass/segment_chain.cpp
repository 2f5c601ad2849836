#include "engine/grass/segment_chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windloom {
namespace {

constexpr float kLeastRate = 0.05f;      // Hz; below it nothing swings
constexpr float kLeastDamping = 0.005f;  // of critical
constexpr float kSlowest = 0.85f;        // a blade's own rate over the meadow's (patchRate)

}  // namespace

ChainBlock makeChainBlock(const GrassSettings& grass) {
  const float rate = 2.0f * std::numbers::pi_v<float> * std::max(grass.swingRate, kLeastRate);
  const float damping = std::clamp(grass.swingDamping, kLeastDamping, 1.0f);
  const float factor = grass.windFactor / std::max(grass.stiffness, 1e-3f);
  const float exponent = std::clamp(grass.windExponent, 1.0f, 2.0f);
  // arcSteadyBend's linear term, and the wind at which any exponent gives the same.
  const float linear = factor / (1.0f - 0.5f * ARC_BEND_PART);
  const float match = CHAIN_MATCH * ARC_ANGLE_LIMIT / std::max(linear, 1e-6f);
  ChainBlock block{};
  // Weight slows an upright blade's swing by the root of 1 - weight.
  block.spring = {rate * rate / (1.0f - CHAIN_WEIGHT), 2.0f * damping * rate, CHAIN_WEIGHT,
                  std::max(grass.height, 0.01f) / (2.0f * static_cast<float>(CHAIN_SEGMENTS))};
  block.wind = {linear * std::pow(match, 1.0f - exponent), exponent, grass.flutter, factor};
  return block;
}

float settledAfter(const GrassSettings& grass) {
  const float rate = kSlowest * 2.0f * std::numbers::pi_v<float> * std::max(grass.swingRate, kLeastRate);
  const float decay = rate * std::clamp(grass.swingDamping, kLeastDamping, 1.0f);
  // A swing from `a` at rest never exceeds a (1 + t decay) exp(-t decay), up to critical damping. From lying flat to
  // 1 mm of the blade's length:
  const float visible = 0.001f / std::max(grass.height, 0.01f);
  const float wanted = std::min(visible / (0.5f * std::numbers::pi_v<float>), 0.5f);
  float x = 0.0f;
  for (int i = 0; i < 40; ++i) x = std::log((1.0f + x) / wanted);
  return x / decay;
}

}  // namespace windloom
