#include "engine/render/solids.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "engine/gpu/debug_group.hpp"
#include "engine/gpu/object_label.hpp"
#include "engine/model/outline.hpp"
#include "engine/render/polygon_mesh.hpp"
#include "engine/render/render_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

constexpr int kMapSide = 1024;             // texels along the longer side: 12 cm of a field of 100 m
constexpr int kStrips = 3, kSectors = 32;  // as in shaders/terrain/solid.vert
constexpr float kFarM = 8.0f;              // distance where no solid is near

}  // namespace

std::vector<Solid> makeSolids(const std::vector<Obstacle>& obstacles, const HeightField* ground) {
  std::vector<Solid> solids;
  float first = 0.0f;
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.hidden) continue;
    const float turn = obstacle.shape == ObstacleShape::Circle ? 0.0f : glm::radians(obstacle.rotation);
    const float kind = obstacle.shape == ObstacleShape::Circle ? SOLID_CIRCLE
                       : obstacle.shape == ObstacleShape::Box  ? SOLID_BOX
                                                               : SOLID_POLYGON;
    const float count = kind == SOLID_POLYGON ? static_cast<float>(obstacle.points.size()) : 0.0f;
    const Standing standing = standingOf(obstacle, ground);
    solids.push_back({{obstacle.centre, halfExtentOf(obstacle)},
                      {std::cos(turn), std::sin(turn), obstacle.height, kind},
                      {standing.footM, standing.topM, first, count}});
    first += count;
  }
  return solids;
}

std::vector<glm::vec2> solidCorners(const std::vector<Obstacle>& obstacles) {
  std::vector<glm::vec2> corners;
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.hidden || obstacle.shape != ObstacleShape::Polygon) continue;
    corners.insert(corners.end(), obstacle.points.begin(), obstacle.points.end());
  }
  return corners;
}

Result<SolidPass> SolidPass::create(gpu::ShaderLibrary& shaders) {
  SolidPass pass;
  if (Status loaded = loadPrograms(shaders, {{"terrain/solid", &pass.m_draw},
                                             {"terrain/solid polygon", &pass.m_drawPolygons},
                                             {"terrain/solid map", &pass.m_drawMap}});
      !loaded) {
    return loaded.error();
  }
  pass.m_noVertices = gpu::VertexArray::create("solids");
  return pass;
}

Status SolidPass::makeMap(glm::ivec2 size) {
  if (m_mapTexture.name() != 0 && glm::ivec2(m_mapTexture.size()) == size) return Done{};
  Result<gpu::Texture> texture = gpu::Texture::create2D("solid map", size, GL_RG16F);
  if (!texture) return texture.error();
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  m_map = gpu::Handle<gpu::FramebufferKind>(name);
  gpu::labelObject(gpu::FramebufferKind::kLabel, name, "solid map");
  m_mapTexture = std::move(*texture);
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, m_mapTexture.name(), 0);
  if (glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    return makeError(ErrorKind::Machine, "OpenGL refuses the framebuffer 'solid map'");
  }
  return Done{};
}

Status SolidPass::configure(const std::vector<Obstacle>& obstacles, const FieldSettings& field,
                            const HeightField* ground) {
  const std::vector<Solid> solids = makeSolids(obstacles, ground);
  const glm::vec2 area = solidMapArea(field).size;
  const glm::ivec2 size = glm::max(glm::ivec2(area / std::max(area.x, area.y) * float(kMapSide)), glm::ivec2(16));
  if (Status made = makeMap(size); !made) return made;
  m_count = static_cast<int>(solids.size());
  m_meshCount = 0;
  m_mapFresh = false;
  if (solids.empty()) return Done{};
  Result<gpu::Buffer> buffer = gpu::Buffer::create("solids", std::span<const Solid>(solids));
  if (!buffer) return buffer.error();
  m_solids = std::move(*buffer);
  return makePolygons(obstacles, ground);
}

Status SolidPass::makePolygons(const std::vector<Obstacle>& obstacles, const HeightField* ground) {
  std::vector<glm::vec2> corners = solidCorners(obstacles);
  if (corners.empty()) corners.emplace_back(0.0f);  // a buffer is never empty
  Result<gpu::Buffer> buffer = gpu::Buffer::create("solid corners", std::span<const glm::vec2>(corners));
  if (!buffer) return buffer.error();
  m_corners = std::move(*buffer);
  const std::vector<PolygonVertex> mesh = makePolygonMesh(obstacles, ground);
  m_meshCount = static_cast<int>(mesh.size());
  if (mesh.empty()) return Done{};
  buffer = gpu::Buffer::create("polygon solids", std::span<const PolygonVertex>(mesh));
  if (!buffer) return buffer.error();
  m_mesh = std::move(*buffer);
  m_meshVertices = gpu::VertexArray::create("polygon solids");
  m_meshVertices.vertexBuffer(0, m_mesh, sizeof(PolygonVertex));
  m_meshVertices.floats(0, 0, 3, offsetof(PolygonVertex, position));
  m_meshVertices.floats(1, 0, 3, offsetof(PolygonVertex, normal));
  m_meshVertices.floats(2, 0, 1, offsetof(PolygonVertex, height));
  return Done{};
}

void SolidPass::updateMap() {
  if (m_mapFresh) return;
  m_mapFresh = true;
  const gpu::DebugGroup group("solid map");
  const float nothing[4] = {kFarM, 1.0f, 0.0f, 0.0f};  // far away, its shadow below the ground
  gpu::apply({.framebuffer = m_map.name(), .viewport = {0, 0, m_mapTexture.size().x, m_mapTexture.size().y}});
  glClearNamedFramebufferfv(m_map.name(), GL_COLOR, 0, nothing);
  if (m_count == 0) return;
  // The least of both values is kept; PassState knows no such blending.
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBlendEquation(GL_MIN);
  m_drawMap->use();
  m_solids.bindStorage(RENDER_SSBO_SOLIDS);
  m_corners.bindStorage(RENDER_SSBO_CORNERS);
  m_noVertices.bind();
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, m_count);
  glBlendEquation(GL_FUNC_ADD);
}

void SolidPass::bindMap() const {
  m_mapTexture.bind(RENDER_TEXTURE_SOLIDS);
}

void SolidPass::draw(const gpu::PassState& state) const {
  if (m_count == 0) return;
  const gpu::DebugGroup group("solids");
  gpu::apply(state);
  m_draw->use();
  m_solids.bindStorage(RENDER_SSBO_SOLIDS);
  m_noVertices.bind();
  glDrawArraysInstanced(GL_TRIANGLES, 0, kStrips * kSectors * 6, m_count);
  if (m_meshCount == 0) return;
  m_drawPolygons->use();
  m_meshVertices.bind();
  glDrawArrays(GL_TRIANGLES, 0, m_meshCount);
}

}  // namespace windloom
