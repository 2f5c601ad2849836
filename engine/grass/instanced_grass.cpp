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

constexpr std::array<int, GRASS_LEVELS> kSegments{6, 3, 1};
// Blades in the lists at most, 96 MB of records: a picture of 1920 x 1080 needs a third of it.
constexpr double kMostBlades = 3e6;
// Without thinning: what a buffer may hold.
constexpr double kMostUnthinned = 6e7;

/// The triangles of a chunk of strips; an index is 16 times the blade plus the vertex.
std::vector<std::uint16_t> stripIndices(int segments) {
  std::vector<std::uint16_t> indices;
  for (unsigned blade = 0; blade < GRASS_CHUNK; ++blade) {
    const auto add = [&](int a, int b, int c) {
      for (const int vertex : {a, b, c}) indices.push_back(static_cast<std::uint16_t>(16u * blade + unsigned(vertex)));
    };
    for (int row = 0; row < segments; ++row) {
      add(2 * row, 2 * row + 1, 2 * row + 2);
      if (row + 1 < segments) add(2 * row + 2, 2 * row + 1, 2 * row + 3);
    }
  }
  return indices;
}

std::uint32_t groupsOf(std::uint32_t tiles) {
  return (tiles + GRASS_CULL_GROUP - 1u) / GRASS_CULL_GROUP;
}

Status grow(gpu::Buffer& buffer, std::string_view label, std::size_t bytes) {
  if (buffer.bytes() >= bytes) return Done{};
  Result<gpu::Buffer> made = gpu::Buffer::create(label, bytes, gpu::BufferUse::Static);
  if (!made) return made.error();
  buffer = std::move(*made);
  return Done{};
}

}  // namespace

Result<InstancedGrass> InstancedGrass::create(gpu::ShaderLibrary& shaders) {
  InstancedGrass grass;
  const std::pair<std::string_view, gpu::Program**> programs[] = {
      {"grass/cull tiles", &grass.m_cull},
      {"grass/scan groups", &grass.m_scan},
      {"grass/list chunks", &grass.m_list},
      {"grass/place blades", &grass.m_place},
      {"grass/blade near", &grass.m_blade[0]},
      {"grass/blade middle", &grass.m_blade[1]},
      {"grass/blade far", &grass.m_blade[2]},
      {"grass/place blades plain", &grass.m_placePlain},
      {"grass/blade near quick", &grass.m_bladeQuick[0]},
      {"grass/blade middle quick", &grass.m_bladeQuick[1]},
      {"grass/blade far quick", &grass.m_bladeQuick[2]},
  };
  for (const auto& [name, slot] : programs) {
    Result<gpu::Program*> program = shaders.load(grassProgram(name));
    if (!program) return program.error();
    *slot = *program;
  }
  Result<gpu::Buffer> settings = gpu::Buffer::create("grass settings", sizeof(GrassBlock), gpu::BufferUse::Dynamic);
  if (!settings) return settings.error();
  Result<gpu::Buffer> commands = gpu::Buffer::create("grass commands", sizeof(GrassCommands), gpu::BufferUse::Static);
  if (!commands) return commands.error();
  Result<gpu::ReadbackRing> counts = gpu::ReadbackRing::create("grass counts", sizeof(GrassCommands));
  if (!counts) return counts.error();
  for (std::size_t level = 0; level < GRASS_LEVELS; ++level) {
    const std::vector<std::uint16_t> indices = stripIndices(kSegments[level]);
    Result<gpu::Buffer> buffer = gpu::Buffer::create("grass strips", std::span<const std::uint16_t>(indices));
    if (!buffer) return buffer.error();
    grass.m_indices[level] = std::move(*buffer);
    grass.m_strips[level] = gpu::VertexArray::create("grass");
    grass.m_strips[level].indexBuffer(grass.m_indices[level]);
  }
  grass.m_settings = std::move(*settings);
  grass.m_commands = std::move(*commands);
  grass.m_counts = std::move(*counts);
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
  if (Status set = setBounds(layout, ground); !set) return set;
  m_layout = layout;
  return Done{};
}

Status InstancedGrass::makeRoomFor(const GrassBlock& block, const GrassQuality& quality, bool chains) {
  const double most = (quality.thinning ? kMostBlades : kMostUnthinned) / GRASS_CHUNK;
  m_chunkLimit = static_cast<std::uint32_t>(std::min(chunksInRange(block), most));
  if (Status made = grow(m_chunks, "grass chunks", m_chunkLimit * sizeof(GrassChunk)); !made) return made;
  if (Status made = grow(m_blades, "grass blades", m_chunkLimit * GRASS_CHUNK * sizeof(GrassBlade)); !made) return made;
  const std::size_t chained = chains ? m_chunkLimit * GRASS_CHUNK : 1u;
  if (Status made = grow(m_chains, "grass chains", chained * sizeof(glm::uvec4)); !made) return made;
  const std::uint32_t tiles = tilesInRings(block);
  if (Status made = grow(m_tileWork, "grass tiles", tiles * sizeof(std::uint32_t)); !made) return made;
  return grow(m_groupWork, "grass groups", groupsOf(tiles) * sizeof(glm::uvec4));
}

Status InstancedGrass::bindSettings(const GrassSettings& grass, std::span<const Species> species,
                                    const GrassQuality& quality, const shared::FrameBlock& frame, int occluderLevels,
                                    Chains chains, Blades blades) {
  GrassBlock block = makeGrassBlock(grass, species, m_layout, quality, frame);
  block.limits.y = chains == Chains::Some ? 1.0f : 0.0f;
  block.limits.z = occluderLevels > 0 ? 1.0f : 0.0f;
  block.limits.w = static_cast<float>(occluderLevels);
  // The ground shows nothing in place of blades that are left out here: they are drawn by others.
  if (blades == Blades::None) block.tileCentre.w = 1.0f;
  if (blades == Blades::Shells) block.tileCentre.w = 2.0f;
  m_settings.write(&block, sizeof block);
  m_settings.bindUniform(RENDER_UBO_GRASS);
  m_tiles = blades == Blades::Drawn ? tilesInRings(block) : 0;
  m_chained = chains == Chains::Some;
  m_quick = quality.quick && !m_chained;
  if (m_tiles == 0) return Done{};
  Status room = makeRoomFor(block, quality, chains == Chains::Some);
  if (!room) m_tiles = 0;
  return room;
}

void InstancedGrass::prepare() {
  if (m_tiles == 0) return;
  const gpu::DebugGroup group("grass: cull and place");
  m_chunks.bindStorage(RENDER_SSBO_CHUNKS);
  m_blades.bindStorage(RENDER_SSBO_BLADES);
  m_commands.bindStorage(RENDER_SSBO_COMMANDS);
  m_bounds.bindStorage(RENDER_SSBO_GRASS_BOUNDS);
  m_tileWork.bindStorage(RENDER_SSBO_TILE_WORK);
  m_groupWork.bindStorage(RENDER_SSBO_GROUP_WORK);
  const std::uint32_t groups = groupsOf(m_tiles);
  m_cull->use();
  m_cull->dispatch(static_cast<int>(groups));
  // The scan reads what cull_tiles counted.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  m_scan->use();
  m_scan->set("groups", groups);
  m_scan->set("chunkLimit", m_chunkLimit);
  m_scan->dispatch(1);
  // list_chunks reads the starts that scan_groups wrote.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  m_list->use();
  m_list->dispatch(static_cast<int>(groups));
  // place_blades reads the chunks of list_chunks and the group count of scan_groups.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  const gpu::Program& place = m_chained ? *m_place : *m_placePlain;
  place.use();
  m_chains.bindStorage(RENDER_SSBO_CHAINS);
  place.dispatchIndirect(m_commands, offsetof(GrassCommands, groupsX));
}

void InstancedGrass::draw(const gpu::PassState& state) {
  if (m_tiles == 0) return;
  const gpu::DebugGroup group("grass: draw");
  gpu::apply(state);
  // The vertex shader reads blades and counts that place_blades wrote, the draws the commands of scan_groups.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  m_chunks.bindStorage(RENDER_SSBO_CHUNKS);
  m_blades.bindStorage(RENDER_SSBO_BLADES);
  m_commands.bindStorage(RENDER_SSBO_COMMANDS);
  m_chains.bindStorage(RENDER_SSBO_CHAINS);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, m_commands.name());
  for (std::size_t level = 0; level < GRASS_LEVELS; ++level) {
    const gpu::Program& blade = m_quick ? *m_bladeQuick[level] : *m_blade[level];
    blade.use();
    blade.set("level", static_cast<unsigned>(level));
    m_strips[level].bind();
    const std::size_t offset = offsetof(GrassCommands, draws) + level * 5 * sizeof(std::uint32_t);
    glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(offset));
  }
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  m_counts.request(m_commands, 0, sizeof(GrassCommands), 0);
}

long long InstancedGrass::bladesDrawn() {
  if (m_tiles == 0) return 0;  // no grass: nothing was counted for a while
  if (const auto arrived = m_counts.poll()) {
    GrassCommands commands{};
    std::memcpy(&commands, arrived->bytes.data(), sizeof commands);
    m_bladesDrawn = commands.blades;
  }
  return m_bladesDrawn;
}

}  // namespace windloom
