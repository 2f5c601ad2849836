#include "engine/grass/instanced_grass.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstring>

#include "engine/gpu/debug_group.hpp"
#include "engine/grass/grass_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

using shared::GrassBlade;
using shared::GrassChunk;
using shared::GrassCommands;

constexpr std::uint32_t kVertices[GRASS_LEVELS] = {13, 7, 3};  // strips of 6, 3 and 1 segments ending in a tip

GrassCommands emptyCommands() {
  GrassCommands commands{};
  commands.groupsX = GRASS_GROUPS_X;
  commands.groupsZ = 1;
  for (std::size_t level = 0; level < GRASS_LEVELS; ++level) commands.draws[level * 4] = kVertices[level];
  return commands;
}

bool sameLists(const GrassLayout& a, const GrassLayout& b) {
  return a.chunkLimit == b.chunkLimit && a.capacity == b.capacity;
}

}  // namespace

Result<InstancedGrass> InstancedGrass::create(gpu::ShaderLibrary& shaders) {
  InstancedGrass grass;
  const std::pair<std::string_view, gpu::Program**> programs[] = {
      {"grass/cull tiles", &grass.m_cull},     {"grass/place blades", &grass.m_place},
      {"grass/blade near", &grass.m_blade[0]}, {"grass/blade middle", &grass.m_blade[1]},
      {"grass/blade far", &grass.m_blade[2]},
  };
  for (const auto& [name, slot] : programs) {
    Result<gpu::Program*> program = shaders.load(grassProgram(name));
    if (!program) return program.error();
    *slot = *program;
  }
  Result<gpu::Buffer> settings = gpu::Buffer::create("grass settings", sizeof(GrassBlock), gpu::BufferUse::Dynamic);
  if (!settings) return settings.error();
  Result<gpu::Buffer> commands = gpu::Buffer::create("grass commands", sizeof(GrassCommands), gpu::BufferUse::Dynamic);
  if (!commands) return commands.error();
  Result<gpu::ReadbackRing> counts = gpu::ReadbackRing::create("grass counts", sizeof(GrassCommands));
  if (!counts) return counts.error();
  grass.m_settings = std::move(*settings);
  grass.m_commands = std::move(*commands);
  grass.m_counts = std::move(*counts);
  grass.m_noVertices = gpu::VertexArray::create("grass");
  return grass;
}

/// How high the ground lies in each tile. Flat ground needs none, but a declared buffer wants something bound.
Status InstancedGrass::setBounds(const GrassLayout& layout, const HeightField* ground) {
  if (ground == nullptr && m_bounds.name() != 0) return Done{};
  const std::vector<glm::vec2> bounds =
      ground != nullptr ? groundInTiles(layout, *ground) : std::vector{glm::vec2(0.0f)};
  if (bounds.empty()) return Done{};
  Result<gpu::Buffer> buffer = gpu::Buffer::create("grass bounds", std::span<const glm::vec2>(bounds));
  if (!buffer) return buffer.error();
  m_bounds = std::move(*buffer);
  return Done{};
}

Status InstancedGrass::configure(const FieldSettings& field, const GrassSettings& grass, const HeightField* ground) {
  const GrassLayout layout = makeGrassLayout(field, grass);
  if (!sameLists(layout, m_layout) && layout.chunkLimit > 0) {
    const std::size_t blades = static_cast<std::size_t>(layout.capacity.x) + layout.capacity.y + layout.capacity.z;
    Result<gpu::Buffer> chunks =
        gpu::Buffer::create("grass chunks", layout.chunkLimit * sizeof(GrassChunk), gpu::BufferUse::Static);
    if (!chunks) return chunks.error();
    Result<gpu::Buffer> list = gpu::Buffer::create("grass blades", blades * sizeof(GrassBlade), gpu::BufferUse::Static);
    if (!list) return list.error();
    m_chunks = std::move(*chunks);
    m_blades = std::move(*list);
  }
  if (Status set = setBounds(layout, ground); !set) return set;
  m_layout = layout;
  return Done{};
}

void InstancedGrass::bindSettings(const GrassSettings& grass, float detail) {
  const GrassBlock block = makeGrassBlock(grass, m_layout, detail);
  m_settings.write(&block, sizeof block);
  m_settings.bindUniform(RENDER_UBO_GRASS);
}

void InstancedGrass::prepare() {
  if (empty()) return;
  const gpu::DebugGroup group("grass: cull and place");
  const GrassCommands commands = emptyCommands();
  // The indirect draws and counters of the last frame read and wrote this buffer.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  m_commands.write(&commands, sizeof commands);
  m_chunks.bindStorage(RENDER_SSBO_CHUNKS);
  m_blades.bindStorage(RENDER_SSBO_BLADES);
  m_commands.bindStorage(RENDER_SSBO_COMMANDS);
  m_bounds.bindStorage(RENDER_SSBO_GRASS_BOUNDS);

  m_cull->use();
  const int tiles = m_layout.tiles.x * m_layout.tiles.y;
  m_cull->dispatch((tiles + 63) / 64);

  // place_blades reads the chunks and the group count that cull_tiles wrote.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  m_place->use();
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, m_commands.name());
  glDispatchComputeIndirect(0);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
}

void InstancedGrass::draw(const gpu::PassState& state) {
  if (empty()) return;
  const gpu::DebugGroup group("grass: draw");
  gpu::apply(state);
  // The vertex shader reads the blades, and the draws their counts, that place_blades wrote.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  m_blades.bindStorage(RENDER_SSBO_BLADES);
  m_noVertices.bind();
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, m_commands.name());
  std::uint32_t start = 0;
  for (std::size_t level = 0; level < GRASS_LEVELS; ++level) {
    m_blade[level]->use();
    m_blade[level]->set("listStart", start);
    const std::size_t offset = offsetof(GrassCommands, draws) + level * 4 * sizeof(std::uint32_t);
    glDrawArraysIndirect(GL_TRIANGLE_STRIP, reinterpret_cast<const void*>(offset));
    start += m_layout.capacity[static_cast<int>(level)];
  }
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  m_counts.request(m_commands, 0, sizeof(GrassCommands), 0);
}

long long InstancedGrass::bladesDrawn() {
  if (empty()) return 0;  // no grass: nothing was counted for a while
  if (const auto arrived = m_counts.poll()) {
    GrassCommands commands{};
    std::memcpy(&commands, arrived->bytes.data(), sizeof commands);
    m_bladesDrawn = 0;
    for (std::size_t level = 0; level < GRASS_LEVELS; ++level) m_bladesDrawn += commands.draws[level * 4 + 1];
  }
  return m_bladesDrawn;
}

}  // namespace windloom
