#include "engine/model/calibration_card.hpp"

#include <cmath>
#include <numbers>

namespace windloom {

glm::vec2 cardWind(glm::vec2 part, double seconds) {
  constexpr float kTurn = 2.0f * std::numbers::pi_v<float>;
  const auto turned = static_cast<float>(std::fmod(seconds / static_cast<double>(kCardPeriod), 1.0));
  return {kCardSpeed * std::cos(kTurn * turned) + kCardCode * std::sin(kTurn * (part.y + 0.125f)),
          kCardSpeed * std::sin(kTurn * turned) + kCardCode * std::sin(kTurn * (2.0f * part.x + 0.125f))};
}

}  // namespace windloom
