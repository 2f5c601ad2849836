#include "engine/grass/rotors.hpp"

#include <cmath>

#include "shaders/shared/render_bindings.h"

namespace windloom {

RotorBlock makeRotorBlock(const std::vector<Rotor>& rotors, double seconds) {
  RotorBlock block{};
  int count = 0;
  for (const Rotor& rotor : rotors) {
    if (rotor.muted || count == ROTOR_MOST) continue;
    // In double: a float would make rings jump after some hours.
    const double turns = static_cast<double>(rotor.rate) * seconds;
    const auto turn = static_cast<float>(turns - std::floor(turns));
    block.rotors[count++] =
        shared::rotorAirOf(rotor.position, rotor.lift, rotor.radius, rotor.speed, rotor.rings, rotor.rate, turn);
  }
  block.count.x = static_cast<float>(count);
  return block;
}

glm::vec3 rotorAir(const RotorBlock& block, glm::vec2 place, float above, float later) {
  glm::vec3 air(0.0f);
  for (int i = 0; i < static_cast<int>(block.count.x); ++i) {
    air += shared::rotorWind(block.rotors[i], place, above, later);
  }
  return air;
}

Result<Rotors> Rotors::create() {
  Rotors rotors;
  Result<gpu::Buffer> block = gpu::Buffer::create("rotors", sizeof(RotorBlock), gpu::BufferUse::Dynamic);
  if (!block) return block.error();
  rotors.m_block = std::move(*block);
  return rotors;
}

void Rotors::bind(const std::vector<Rotor>& rotors, double seconds) {
  const RotorBlock block = makeRotorBlock(rotors, seconds);
  m_block.write(&block, sizeof block);
  m_block.bindUniform(RENDER_UBO_ROTORS);
}

}  // namespace windloom
