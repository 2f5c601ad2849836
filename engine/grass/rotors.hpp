#pragma once
// The air of the project's rotors for every shader that asks for the wind (shaders/include/wind_field.glsl). It is no
// part of the simulated field: probes, `sample` and exports don't have it.

#include "engine/core/result.hpp"
#include "engine/gpu/buffer.hpp"
#include "engine/model/project.hpp"
#include "shaders/shared/rotor_wind.h"

namespace windloom {

using shared::RotorBlock;

/// The first ROTOR_MOST rotors that aren't muted, as they blow at `seconds` of simulated time.
RotorBlock makeRotorBlock(const std::vector<Rotor>& rotors, double seconds);

/// Their air at a place `above` m over the ground, m/s, `later` s after the block's time: what shaders add up.
glm::vec3 rotorAir(const RotorBlock& block, glm::vec2 place, float above, float later = 0.0f);

class Rotors {
 public:
  /// Fails with Machine.
  static Result<Rotors> create();

  /// For all passes of a frame at this time.
  void bind(const std::vector<Rotor>& rotors, double seconds);

 private:
  Rotors() = default;

  gpu::Buffer m_block;
};

}  // namespace windloom
