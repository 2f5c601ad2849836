#include "engine/grass/grass_patches.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/core/log.hpp"
#include "engine/gpu/debug_group.hpp"
#include "engine/grass/grass_programs.hpp"
#include "engine/grass/segment_chain.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

using shared::PatchEntry;
using shared::PatchTableHead;

std::size_t atLeastOne(int count) {
  return static_cast<std::size_t>(std::max(count, 1));
}

std::size_t tableBytes(int slots) {
  std::size_t entries = 16;
  while (entries < 2 * atLeastOne(slots)) entries *= 2;
  return sizeof(PatchTableHead) + entries * sizeof(PatchEntry);
}

}  // namespace

Result<GrassPatches> GrassPatches::create(gpu::ShaderLibrary& shaders) {
  GrassPatches patches;
  Result<gpu::Program*> program = shaders.load(grassProgram("grass/step patches"));
  if (!program) return program.error();
  patches.m_program = *program;
  if (Status made = patches.makeRoom(patches.m_cells); !made) return made.error();
  if (Status made = patches.makePrimitiveRoom(16); !made) return made.error();
  return patches;
}

Status GrassPatches::makeRoom(const PatchCells& cells) {
  using gpu::Buffer;
  using gpu::BufferUse;
  const std::size_t blades = atLeastOne(cells.slots() * cells.stride());
  Result<Buffer> list =
      Buffer::create("grass patches", atLeastOne(cells.slots()) * sizeof(GrassPatch), BufferUse::Dynamic);
  if (!list) return list.error();
  Result<Buffer> table = Buffer::create("grass patch table", tableBytes(cells.slots()), BufferUse::Dynamic);
  if (!table) return table.error();
  Result<Buffer> state =
      Buffer::create("grass patch blades", blades * CHAIN_SEGMENTS * sizeof(glm::vec4), BufferUse::Static);
  if (!state) return state.error();
  m_patches = std::move(*list);
  m_table = std::move(*table);
  m_state = std::move(*state);
  m_sent = 0;
  return Done{};
}

Status GrassPatches::makePrimitiveRoom(std::size_t count) {
  Result<gpu::Buffer> buffer =
      gpu::Buffer::create("grass colliders", count * sizeof(ColliderPrimitive), gpu::BufferUse::Dynamic);
  if (!buffer) return buffer.error();
  m_primitives = std::move(*buffer);
  return Done{};
}

Status GrassPatches::configure(const GrassSettings& grass, const GrassLayout& layout, float tallestM) {
  PatchLimits limits;
  limits.tileSideM = layout.tileSideM;
  // Clumps vary it, and a map may double it.
  limits.reachM = (grass.heightPixels != nullptr ? 2.5f : 1.25f) * tallestM;
  limits.bladesInTile = static_cast<int>(std::floor(layout.bladesInTile)) + 1;
  limits.blades = layout.empty() ? 0 : std::max(grass.interacting, 0);
  limits.settledAfterS = settledAfter(grass);
  PatchCells cells = m_cells;
  cells.configure(limits);
  if (cells.slots() != m_cells.slots() || cells.stride() != m_cells.stride()) {
    if (Status made = makeRoom(cells); !made) return made;
  }
  m_cells = std::move(cells);
  const ChainBlock chain = makeChainBlock(grass);
  // The deviation's spring bears no weight: that is in the pose.
  m_stiffness = chain.spring.x * (1.0f - CHAIN_WEIGHT);
  m_damping = chain.spring.y;
  return Done{};
}

void GrassPatches::upload() {
  const std::vector<GrassPatch>& patches = m_cells.patches();
  m_patches.write(std::span<const GrassPatch>(patches));
  m_primitives.write(std::span<const ColliderPrimitive>(m_cells.near()));
  if (m_sent == m_cells.generation()) return;
  m_sent = m_cells.generation();
  const std::vector<PatchEntry> entries = patchTable(patches);
  const auto stride = static_cast<std::uint32_t>(m_cells.stride());
  const PatchTableHead head{static_cast<std::uint32_t>(entries.size() - 1), static_cast<std::uint32_t>(patches.size()),
                            stride, stride * static_cast<std::uint32_t>(m_cells.slots())};
  m_table.write(&head, sizeof head);
  m_table.write(std::span<const PatchEntry>(entries), sizeof head);
}

void GrassPatches::step(const DynamicsStep& step, std::span<const ColliderPrimitive> primitives,
                        const HeightField* ground) {
  if (step.jumped) m_cells.clear();
  m_cells.step(step.seconds, primitives, ground);
  if (const std::size_t count = m_cells.near().size(); m_primitives.bytes() < count * sizeof(ColliderPrimitive)) {
    if (Status made = makePrimitiveRoom(count + count / 2); !made) {
      logError(made.error().text());
      m_cells.clear();
    }
  }
  // The last step and frame read what is written now, and the last step wrote the state.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  upload();
  if (m_cells.patches().empty()) return;
  const gpu::DebugGroup group("grass: step patches");
  m_patches.bindStorage(RENDER_SSBO_PATCHES);
  m_primitives.bindStorage(RENDER_SSBO_PRIMITIVES);
  m_table.bindStorage(RENDER_SSBO_PATCH_TABLE);
  m_state.bindStorage(RENDER_SSBO_PATCH_STATE);
  m_program->set("dtSeconds", step.seconds);
  m_program->set("swingStiffness", m_stiffness);
  m_program->set("swingDamping", m_damping);
  const int groups = (m_cells.stride() + PATCH_GROUP - 1) / PATCH_GROUP;
  m_program->dispatch(groups, static_cast<int>(m_cells.patches().size()));
}

void GrassPatches::bind() const {
  // step_patches wrote the state.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  m_table.bindStorage(RENDER_SSBO_PATCH_TABLE);
  m_state.bindStorage(RENDER_SSBO_PATCH_STATE);
}

std::size_t GrassPatches::memoryBytes() const {
  return m_patches.bytes() + m_table.bytes() + m_state.bytes() + m_primitives.bytes();
}

}  // namespace windloom
