#pragma once
// The solved response: how plants of four stiffnesses lean in the recorded wind, so that a game needs no springs of its
// own. Each cell holds a damped oscillator for each class: x'' + 2 d w x' + w^2 (x - target(wind)) = 0.

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <string_view>
#include <vector>

namespace windloom {

struct PlantClass {
  std::string_view name;  ///< of its track
  float bend;             ///< rad the tip leans in a steady weak wind of 1 m/s
  float frequency;        ///< Hz, undamped
  float damping;          ///< ratio; 1: critical
};

/// Soft grass, limber reeds, firm shrubs, stiff trees.
std::span<const PlantClass, 4> plantClasses();

/// rad: no steady wind leans a plant further; saturates as the meadow's blades do (shaders/shared/blade_deformation.h).
inline constexpr float kSteadyBendLimit = 1.2f;
/// rad: full scale of integer formats; a plant that swings back may pass the steady limit a little.
inline constexpr float kBendFullScale = 1.5f;

class PlantResponse {
 public:
  explicit PlantResponse(std::size_t cells);

  /// The first call rests every plant in that wind; later ones let `seconds` pass in which the wind changes linearly
  /// from the last one to this. Exact for any length of time (no step to choose).
  void advance(std::span<const glm::vec2> wind, double seconds);

  /// Direction times angle of the tip in rad, a value a cell, of class 0 to 3.
  [[nodiscard]] std::span<const glm::vec2> bend(int plantClass) const;

 private:
  struct State {
    std::vector<glm::vec2> bend, speed;  // rad, rad/s
  };
  std::vector<glm::vec2> m_wind;
  std::array<State, 4> m_states;
  bool m_begun = false;
};

}  // namespace windloom
