#include "engine/grass/virtual_blades.hpp"

#include <epoxy/gl.h>

#include <algorithm>

#include "engine/gpu/debug_group.hpp"
#include "engine/grass/grass_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

constexpr std::size_t kNumbers = 6 * CHAIN_SEGMENTS;  // of a blade

std::size_t bladesOf(glm::ivec2 size) {
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}

}  // namespace

glm::ivec2 virtualGrid(glm::ivec2 windCells, int most) {
  const int divisor = (std::max({windCells.x, windCells.y, 1}) + most - 1) / most;
  return glm::max((windCells + divisor - 1) / divisor, glm::ivec2(1));
}

Result<VirtualBlades> VirtualBlades::create(gpu::ShaderLibrary& shaders) {
  VirtualBlades blades;
  Result<gpu::Program*> program = shaders.load(grassProgram("grass/virtual blades"));
  if (!program) return program.error();
  blades.m_program = *program;
  Result<gpu::Buffer> chain = gpu::Buffer::create("chain settings", sizeof(ChainBlock), gpu::BufferUse::Dynamic);
  if (!chain) return chain.error();
  blades.m_chain = std::move(*chain);
  if (Status made = blades.makeGrid({1, 1}); !made) return made.error();
  return blades;
}

Status VirtualBlades::makeGrid(glm::ivec2 size) {
  Result<gpu::Buffer> state =
      gpu::Buffer::create("virtual blades", bladesOf(size) * kNumbers * sizeof(float), gpu::BufferUse::Static);
  if (!state) return state.error();
  Result<gpu::Texture> moments =
      gpu::Texture::createArray("virtual wind", size, 2, GL_RGBA16F, {.filter = gpu::Filter::Linear});
  if (!moments) return moments.error();
  moments->clear();
  m_state = std::move(*state);
  m_moments = std::move(*moments);
  m_fresh = true;
  return Done{};
}

Status VirtualBlades::configure(const GrassSettings& grass, glm::ivec2 windCells, int most) {
  const glm::ivec2 size = virtualGrid(windCells, most);
  if (size != grid()) {
    if (Status made = makeGrid(size); !made) return made;
  }
  m_block = makeChainBlock(grass);
  m_block.grid = {glm::vec2(size), 0.0f, 0.0f};
  m_chain.write(&m_block, sizeof m_block);
  return Done{};
}

void VirtualBlades::step(const DynamicsStep& step) {
  const bool settle = m_fresh || step.jumped;
  if (!settle && step.seconds <= 0.0f) return;
  const gpu::DebugGroup group("grass: virtual blades");
  // The last step wrote state and moments, and passes of the last frame read the moments.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  m_chain.bindUniform(RENDER_UBO_CHAIN);
  m_state.bindStorage(RENDER_SSBO_VIRTUAL_BLADES);
  m_moments.bindImage(RENDER_IMAGE_VIRTUAL_WIND, GL_WRITE_ONLY);
  m_program->set("dtSeconds", settle ? 0.0f : step.seconds);
  m_program->dispatchOver(grid());
  m_fresh = false;
}

void VirtualBlades::bind() const {
  // virtual_blades wrote the moments.
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  m_chain.bindUniform(RENDER_UBO_CHAIN);
  m_moments.bind(RENDER_TEXTURE_VIRTUAL_WIND);
}

std::size_t VirtualBlades::memoryBytes() const {
  return bladesOf(grid()) * (kNumbers * sizeof(float) + 2 * 4 * sizeof(std::uint16_t));
}

}  // namespace windloom
