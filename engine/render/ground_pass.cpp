#include "engine/render/ground_pass.hpp"

#include <epoxy/gl.h>

#include <algorithm>

#include "engine/gpu/debug_group.hpp"
#include "engine/render/buffer_room.hpp"
#include "engine/render/ground_light.hpp"
#include "engine/render/render_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

// The mesh may be off by so many pixels. Grass and overlays stand on the true height; more than a pixel shows.
constexpr float kFullPixels = 0.75f, kQuickPixels = 1.5f;
constexpr long kFullTriangles = 2'000'000, kQuickTriangles = 150'000;

std::vector<std::uint32_t> latticeIndices(int level) {
  const auto quads = static_cast<std::uint32_t>(GROUND_TILE_SIDE >> level), side = quads + 1;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t z = 0; z < quads; ++z) {
    for (std::uint32_t x = 0; x < quads; ++x) {
      const std::uint32_t a = z * side + x, b = a + 1, c = a + side, d = c + 1;
      for (const std::uint32_t index : {a, c, b, b, c, d}) indices.push_back(index);
    }
  }
  return indices;
}

}  // namespace

Result<GroundPass> GroundPass::create(gpu::ShaderLibrary& shaders) {
  GroundPass pass;
  if (Status loaded = loadPrograms(shaders, {{"terrain/ground mesh", &pass.m_programs[0]},
                                             {"terrain/ground mesh quick", &pass.m_programs[1]},
                                             {"terrain/ground mesh plain", &pass.m_programs[2]}});
      !loaded) {
    return loaded.error();
  }
  // Flat ground reads neither, but samplers want a texture.
  for (gpu::Texture* texture : {&pass.m_heightTexture, &pass.m_lightTexture}) {
    Result<gpu::Texture> made = gpu::Texture::create2D("no ground", {1, 1}, GL_R8);
    if (!made) return made.error();
    made->clear();
    *texture = std::move(*made);
  }
  return pass;
}

Status GroundPass::makeLattices() {
  if (m_indices[0].name() != 0) return Done{};
  for (int level = 0; level < GROUND_LEVELS; ++level) {
    const auto at = static_cast<std::size_t>(level);
    Result<gpu::Buffer> indices =
        gpu::Buffer::create("ground lattice", std::span<const std::uint32_t>(latticeIndices(level)));
    if (!indices) return indices.error();
    m_indices[at] = std::move(*indices);
    m_lattices[at] = gpu::VertexArray::create("ground");
    m_lattices[at].indexBuffer(m_indices[at]);
  }
  return Done{};
}

Status GroundPass::configure(Shared<HeightField> heights, glm::vec3 towardsSun) {
  if (heights == m_heights) return Done{};
  if (!heights) {
    m_heights.reset();
    return Done{};
  }
  if (Status made = makeLattices(); !made) return made;
  const HeightSource& source = *heights->source;
  if (!m_heights || m_heights->source != heights->source) {
    Result<gpu::Texture> texture =
        gpu::Texture::create2D("ground heights", source.samples, GL_R32F, {.filter = gpu::Filter::Nearest});
    if (!texture) return texture.error();
    Result<gpu::Texture> light = gpu::Texture::create2D("ground light", source.samples, GL_RGBA16F,
                                                        {.levels = 0, .filter = gpu::Filter::Trilinear});
    if (!light) return light.error();
    texture->upload(GL_RED, GL_FLOAT, source.values.data());
    m_heightTexture = std::move(*texture);
    m_lightTexture = std::move(*light);
  }
  m_lightTexture.upload(GL_RGBA, GL_FLOAT, makeGroundLight(*heights, towardsSun).data());
  m_lightTexture.generateMipmaps();
  m_tiles = measureGroundTiles(*heights);
  m_heights = std::move(heights);
  return Done{};
}

void GroundPass::bind() const {
  m_heightTexture.bind(RENDER_TEXTURE_GROUND);
  m_lightTexture.bind(RENDER_TEXTURE_GROUND_LIGHT);
}

void GroundPass::draw(const gpu::PassState& state, const FrameBlock& frame, const ViewCamera& camera,
                      Backdrop::GroundDetail detail) {
  const gpu::DebugGroup group("ground mesh");
  const bool full = detail == Backdrop::GroundDetail::Full;
  const glm::vec2 eye(camera.position.x, camera.position.z);
  const float away = glm::length(eye - glm::clamp(eye, m_heights->low, m_heights->low + m_heights->size));
  const float reach =
      away + (camera.orthographic ? 4.0f * camera.orthographicHeight + camera.farPlane : 0.98f * camera.farPlane);
  const GroundSelection selection = selectGroundTiles(
      *m_heights, m_tiles, frame, reach, full ? kFullPixels : kQuickPixels, full ? kFullTriangles : kQuickTriangles);
  std::vector<GroundTile> tiles;
  for (const auto& level : selection.levels) tiles.insert(tiles.end(), level.begin(), level.end());
  if (tiles.empty()) return;
  if (!makeRoom(m_tilesInView, "ground tiles", tiles.size() * sizeof(GroundTile))) return;
  m_tilesInView.write(std::span<const GroundTile>(tiles));
  gpu::apply(state);
  const gpu::Program& program = *m_programs[static_cast<std::size_t>(detail)];
  program.use();
  program.set("reach", reach);
  m_tilesInView.bindStorage(RENDER_SSBO_GROUND_TILES);
  int first = 0;
  for (int level = 0; level < GROUND_LEVELS; ++level) {
    const auto count = static_cast<int>(selection.levels[static_cast<std::size_t>(level)].size());
    if (count == 0) continue;
    program.set("level", level);
    program.set("firstTile", first);
    m_lattices[static_cast<std::size_t>(level)].bind();
    const int quads = GROUND_TILE_SIDE >> level;
    glDrawElementsInstanced(GL_TRIANGLES, 6 * quads * quads, GL_UNSIGNED_INT, nullptr, count);
    first += count;
  }
}

}  // namespace windloom
