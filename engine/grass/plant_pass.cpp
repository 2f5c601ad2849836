#include "engine/grass/plant_pass.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>

#include "engine/gpu/debug_group.hpp"
#include "engine/grass/flower_mesh.hpp"
#include "engine/grass/grass_layout.hpp"
#include "engine/grass/grass_programs.hpp"
#include "engine/grass/mesh_simplify.hpp"
#include "engine/grass/plant_texture_mips.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

using shared::PlantCommand;
using shared::PlantInstance;

// Triangles of a mesh's smaller version.
constexpr std::size_t kFarTriangles = 64;
// Slots of a vertex array.
constexpr unsigned kMeshSlot = 0, kPlantSlot = 1;

/// What is on the GPU would come out the same.
bool sameMesh(const Species& a, const Species& b) {
  if (a.shape != b.shape || a.mesh != b.mesh) return false;
  return a.shape == PlantShape::Mesh ||
         (a.height == b.height && a.width == b.width && a.baseColour == b.baseColour && a.tipColour == b.tipColour);
}

PlantMeshSummary summaryOf(const PlantMesh& mesh) {
  return {mesh.low, mesh.high, mesh.indices.size() / 3, mesh.alphaCutoff};
}

/// A card's upper edge must not meet the lower one of a picture that isn't repeated.
gpu::Wrap wrapOf(const PlantMesh& mesh) {
  constexpr float kSlack = 0.01f;
  const bool within = std::ranges::all_of(mesh.vertices, [](const PlantVertex& v) {
    return std::min(v.uv.x, v.uv.y) >= -kSlack && std::max(v.uv.x, v.uv.y) <= 1.0f + kSlack;
  });
  return within ? gpu::Wrap::Clamp : gpu::Wrap::Repeat;
}

}  // namespace

Result<PlantPass> PlantPass::create(gpu::ShaderLibrary& shaders) {
  PlantPass pass;
  Result<gpu::Program*> place = shaders.load(grassProgram("grass/place plants"));
  if (!place) return place.error();
  Result<gpu::Program*> plain = shaders.load(grassProgram("grass/plant"));
  if (!plain) return plain.error();
  Result<gpu::Program*> textured = shaders.load(grassProgram("grass/plant textured"));
  if (!textured) return textured.error();
  constexpr std::size_t kCommandBytes = PLANT_KINDS * PLANT_LEVELS * sizeof(PlantCommand);
  Result<gpu::Buffer> commands = gpu::Buffer::create("plant commands", kCommandBytes, gpu::BufferUse::Dynamic);
  if (!commands) return commands.error();
  Result<gpu::Buffer> blocks =
      gpu::Buffer::create("plant kinds", PLANT_KINDS * sizeof(PlantKind), gpu::BufferUse::Dynamic);
  if (!blocks) return blocks.error();
  pass.m_place = *place;
  pass.m_plain = *plain;
  pass.m_textured = *textured;
  pass.m_commands = std::move(*commands);
  pass.m_blocks = std::move(*blocks);
  return pass;
}

Status PlantPass::upload(Kind& kind, const PlantMesh& near, const PlantMesh& far) {
  std::vector<PlantVertex> vertices = near.vertices;
  vertices.insert(vertices.end(), far.vertices.begin(), far.vertices.end());
  std::vector<std::uint32_t> indices = near.indices;
  indices.insert(indices.end(), far.indices.begin(), far.indices.end());
  Result<gpu::Buffer> vertexBuffer = gpu::Buffer::create("plant mesh", std::span<const PlantVertex>(vertices));
  if (!vertexBuffer) return vertexBuffer.error();
  Result<gpu::Buffer> indexBuffer = gpu::Buffer::create("plant indices", std::span<const std::uint32_t>(indices));
  if (!indexBuffer) return indexBuffer.error();
  kind.vertices = std::move(*vertexBuffer);
  kind.indices = std::move(*indexBuffer);
  kind.count[0] = static_cast<std::uint32_t>(near.indices.size());
  kind.count[1] = static_cast<std::uint32_t>(far.indices.size());
  kind.firstIndex[1] = kind.count[0];
  kind.baseVertex[1] = static_cast<std::uint32_t>(near.vertices.size());
  kind.array = gpu::VertexArray::create("plant");
  kind.array.vertexBuffer(kMeshSlot, kind.vertices, sizeof(PlantVertex));
  kind.array.floats(0, kMeshSlot, 3, offsetof(PlantVertex, position));
  kind.array.floats(1, kMeshSlot, 3, offsetof(PlantVertex, normal));
  kind.array.floats(2, kMeshSlot, 2, offsetof(PlantVertex, uv));
  kind.array.floats(3, kMeshSlot, 4, offsetof(PlantVertex, colour));
  kind.array.indexBuffer(kind.indices);
  return Done{};
}

Status PlantPass::makeTexture(Kind& kind, const PlantMesh& mesh) {
  const std::vector<MipLevel> levels = mipLevels(mesh);
  if (levels.empty()) return Done{};
  const gpu::TextureOptions options{.levels = 0, .filter = gpu::Filter::Trilinear, .wrap = wrapOf(mesh)};
  Result<gpu::Texture> texture = gpu::Texture::create2D("plant", mesh.textureSize, GL_SRGB8_ALPHA8, options);
  if (!texture) return texture.error();
  for (std::size_t level = 0; level < levels.size(); ++level)
    texture->upload(GL_RGBA, GL_UNSIGNED_BYTE, levels[level].pixels.data(), static_cast<int>(level));
  kind.texture = std::move(*texture);
  return Done{};
}

Status PlantPass::makeMesh(Kind& kind, const Species& species) {
  kind.made = species;
  if (species.shape != PlantShape::Mesh) {
    const FlowerMesh flower = makeFlower(species);
    kind.mesh = summaryOf(flower.near);
    return upload(kind, flower.near, flower.far);
  }
  if (Status made = makeTexture(kind, *species.mesh); !made) return made;
  kind.mesh = summaryOf(*species.mesh);
  return upload(kind, *species.mesh, simplified(*species.mesh, kFarTriangles));
}

void PlantPass::bindPlants(Kind& kind) const {
  kind.array.vertexBuffer(kPlantSlot, m_plants, sizeof(PlantInstance), 1);
  kind.array.floats(4, kPlantSlot, 3, offsetof(PlantInstance, x));
  kind.array.uints(5, kPlantSlot, 1, offsetof(PlantInstance, sizes));
  kind.array.uints(6, kPlantSlot, 4, offsetof(PlantInstance, bend));
  kind.array.uints(7, kPlantSlot, 3, offsetof(PlantInstance, tint));
}

/// Gives each species its part of the list and makes the list anew where it is too short.
Status PlantPass::makeRoom(std::vector<PlantKind>& blocks, const FieldSettings& field) {
  std::uint32_t all = 0;
  for (PlantKind& block : blocks) {
    const glm::uvec2 room = plantRoom(block, field);
    for (int level = 0; level < static_cast<int>(PLANT_LEVELS); ++level) {
      block.first[level] = all;
      block.room[level] = room[level];
      all += room[level];
    }
  }
  const std::size_t bytes = static_cast<std::size_t>(all) * sizeof(PlantInstance);
  if (bytes <= m_plants.bytes() && bytes >= m_plants.bytes() / 4) return Done{};
  Result<gpu::Buffer> plants =
      gpu::Buffer::create("plants", std::max(bytes, sizeof(PlantInstance)), gpu::BufferUse::Static);
  if (!plants) return plants.error();
  m_plants = std::move(*plants);
  return Done{};
}

Status PlantPass::configure(const FieldSettings& field, const GrassSettings& grass,
                            const std::vector<Species>& species) {
  const std::vector<std::size_t> shown = meshSpecies(grass, species);
  const auto known = [&](const Species& one) {
    return std::ranges::find_if(m_kinds,
                                [&](const Kind& kind) { return kind.made.id == one.id && sameMesh(kind.made, one); });
  };
  // All that may fail comes before anything is taken from the kinds there are.
  std::vector<Kind> fresh(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const Species& one = species[shown[i]];
    if (known(one) != m_kinds.end()) continue;
    if (Status made = makeMesh(fresh[i], one); !made) return made;
  }
  std::vector<PlantKind> blocks;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const auto old = known(species[shown[i]]);
    const Kind& kind = old != m_kinds.end() ? *old : fresh[i];
    blocks.push_back(makePlantKind(grass, species, shown[i], kind.mesh));
  }
  if (Status made = makeRoom(blocks, field); !made) return made;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (const auto old = known(species[shown[i]]); old != m_kinds.end()) fresh[i] = std::move(*old);
    fresh[i].index = shown[i];
    fresh[i].block = blocks[i];
    bindPlants(fresh[i]);
  }
  m_field = field;
  m_kinds = std::move(fresh);
  for (std::size_t i = 0; i < m_kinds.size(); ++i)
    m_blocks.write(&m_kinds[i].block, sizeof(PlantKind), i * sizeof(PlantKind));
  return Done{};
}

void PlantPass::prepare(const PlantView& view) {
  if (m_kinds.empty()) return;
  const gpu::DebugGroup group("plants: place");
  std::vector<PlantCommand> commands;
  for (const Kind& kind : m_kinds) {
    for (std::size_t level = 0; level < PLANT_LEVELS; ++level)
      commands.push_back(
          {kind.count[level], 0, kind.firstIndex[level], kind.baseVertex[level], kind.block.first[level]});
  }
  // The draws of the last frame read this buffer and place_plants counted in it.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  m_commands.write(std::span<const PlantCommand>(commands));
  m_plants.bindStorage(RENDER_SSBO_PLANTS);
  m_commands.bindStorage(RENDER_SSBO_PLANT_COMMANDS);
  m_blocks.bindStorage(RENDER_SSBO_PLANT_KINDS);
  m_place->use();
  m_place->set("detail", std::clamp(view.detail, 0.02f, 1.0f));
  m_place->set("margin", kMeadowMarginM);
  m_place->set("thinning", view.thinning ? 1 : 0);
  m_place->set("culling", view.culling ? 1 : 0);
  for (std::size_t i = 0; i < m_kinds.size(); ++i) {
    const PlantCells cells = cellsInReach(m_kinds[i].block, m_field, view);
    if (cells.count.x <= 0 || cells.count.y <= 0) continue;
    m_place->set("species", static_cast<int>(i));
    m_place->set("firstCell", cells.first);
    m_place->dispatch(cells.count.x, cells.count.y);
  }
}

void PlantPass::draw(const gpu::PassState& state) {
  if (m_kinds.empty()) return;
  const gpu::DebugGroup group("plants: draw");
  // The draws read the plants as vertices, and their counts, that place_plants wrote.
  glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  m_blocks.bindStorage(RENDER_SSBO_PLANT_KINDS);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, m_commands.name());
  for (std::size_t i = 0; i < m_kinds.size(); ++i) {
    const Kind& kind = m_kinds[i];
    const bool textured = kind.texture.name() != 0;
    gpu::PassState own = state;
    own.coverage = textured ? gpu::Coverage::FromAlpha : gpu::Coverage::Off;
    gpu::apply(own);
    gpu::Program& program = textured ? *m_textured : *m_plain;
    program.use();
    program.set("species", static_cast<int>(i));
    program.set("alphaCutoff", kind.mesh.alphaCutoff);
    if (textured) kind.texture.bind(RENDER_TEXTURE_PLANT);
    kind.array.bind();
    const std::size_t offset = i * PLANT_LEVELS * sizeof(PlantCommand);
    glMultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset), PLANT_LEVELS, 0);
  }
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

std::vector<PlantInstance> PlantPass::placed(std::size_t species) const {
  std::vector<PlantInstance> all;
  for (std::size_t i = 0; i < m_kinds.size(); ++i) {
    if (m_kinds[i].index != species) continue;
    for (std::size_t level = 0; level < PLANT_LEVELS; ++level) {
      PlantCommand command{};
      m_commands.read(&command, sizeof command, (i * PLANT_LEVELS + level) * sizeof command);
      if (command.instances == 0) continue;
      std::vector<PlantInstance> some(command.instances);
      m_plants.read(some.data(), some.size() * sizeof(PlantInstance), command.baseInstance * sizeof(PlantInstance));
      all.insert(all.end(), some.begin(), some.end());
    }
  }
  return all;
}

}  // namespace windloom
