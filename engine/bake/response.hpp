#pragma once
// The solved response: how plants of four stiffnesses lean in the recorded wind, so that a game needs no springs of its
// own. Each cell holds a damped oscillator for each class: x'' + 2 d w x' + w^2 (x - target(wind)) = 0.

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/thread_pool.hpp"

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

/// How far such a plant leans in a steady wind of (x, z) m/s: direction times angle of the tip, rad.
glm::vec2 steadyBend(const PlantClass& plants, glm::vec2 wind);

/// What a while does to an oscillator whose target moves evenly from one place to another: bend and speed afterwards
/// are the sums of these factors times bend, speed (a second), first and last target. Exact for any damping >= 0 and
/// any seconds > 0.
struct OscillatorStep {
  std::array<float, 4> bend, speed;
};
OscillatorStep oscillatorStep(float frequency, float damping, double seconds);

class PlantResponse {
 public:
  explicit PlantResponse(std::size_t cells);

  /// The first call rests every plant in that wind; later ones let `seconds` (>= 0) pass in which each plant's steady
  /// bend goes evenly from that of the last wind to that of this one. Exact for any length of time: there is no step to
  /// choose. The same bytes for any number of threads.
  void advance(std::span<const glm::vec2> wind, double seconds);

  /// Direction times angle of the tip in rad, a value a cell, of class 0 to 3.
  [[nodiscard]] std::span<const glm::vec2> bend(int plantClass) const;

 private:
  struct State {
    std::vector<glm::vec2> bend, speed, target;  // rad, rad/s, rad
  };
  void restChunk(std::span<const glm::vec2> wind, std::size_t first, std::size_t end);
  void advanceChunk(std::span<const glm::vec2> wind, const std::array<OscillatorStep, 4>& steps, std::size_t first,
                    std::size_t end);

  std::size_t m_cells;
  std::array<State, 4> m_states;
  std::unique_ptr<ThreadPool> m_pool;
  bool m_begun = false;
};

}  // namespace windloom
