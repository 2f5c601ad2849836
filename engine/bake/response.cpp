#include "engine/bake/response.hpp"

#include <cmath>

#include "shaders/shared/blade_deformation.h"

namespace windloom {

std::span<const PlantClass, 4> plantClasses() {
  static constexpr PlantClass kClasses[4] = {{"bend-soft", 0.12f, 2.5f, 0.25f},
                                             {"bend-limber", 0.08f, 1.5f, 0.2f},
                                             {"bend-firm", 0.04f, 1.0f, 0.15f},
                                             {"bend-stiff", 0.015f, 0.35f, 0.1f}};
  return kClasses;
}

PlantResponse::PlantResponse(std::size_t cells) : m_wind(cells) {
  for (State& state : m_states) {
    state.bend.resize(cells);
    state.speed.resize(cells);
  }
}

void PlantResponse::advance(std::span<const glm::vec2> wind, double) {
  for (std::size_t c = 0; c < m_states.size(); ++c) {
    for (std::size_t i = 0; i < wind.size(); ++i) {
      const glm::vec2 bend = wind[i] * plantClasses()[c].bend;
      const float size = glm::length(bend);
      m_states[c].bend[i] = size > 0.0f ? bend * (shared::saturateBend(size, kSteadyBendLimit) / size) : bend;
    }
  }
}

std::span<const glm::vec2> PlantResponse::bend(int plantClass) const {
  return m_states[static_cast<std::size_t>(plantClass)].bend;
}

}  // namespace windloom
