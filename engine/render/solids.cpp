#include "engine/render/solids.hpp"

#include <algorithm>
#include <cmath>

#include "engine/gpu/debug_group.hpp"
#include "engine/gpu/object_label.hpp"
#include "engine/render/render_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

constexpr int kMapSide = 1024;           // texels along the longer side: 12 cm of a field of 100 m
constexpr int kStrips = 3, kSectors = 32;  // as in shaders/terrain/solid.vert
constexpr float kFarM = 8.0f;            // distance where no solid is near

}  // namespace

std::vector<Solid> makeSolids(const std::vector<Obstacle>& obstacles) {
  std::vector<Solid> solids;
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.hidden) continue;
    const bool circle = obstacle.shape == ObstacleShape::Circle;
    const glm::vec2 half = circle ? glm::vec2(obstacle.radius) : 0.5f * obstacle.size;
    const float turn = circle ? 0.0f : glm::radians(obstacle.rotation);
    solids.push_back({{obstacle.centre, half}, {std::cos(turn), std::sin(turn), obstacle.height, circle ? SOLID_CIRCLE : SOLID_BOX}});
  }
  return solids;
}

Result<SolidPass> SolidPass::create(gpu::ShaderLibrary& shaders) {
  SolidPass pass;
  if (Status loaded = loadPrograms(shaders, {{"terrain/solid", &pass.m_draw}, {"terrain/solid map", &pass.m_drawMap}}); !loaded) {
    return loaded.error();
  }
  pass.m_noVertices = gpu::VertexArray::create("solids");
  return pass;
}

Status SolidPass::makeMap(glm::ivec2 size) {
  if (m_distance.name() != 0 && glm::ivec2(m_distance.size()) == size) return Done{};
  Result<gpu::Texture> distance = gpu::Texture::create2D("solid distance", size, GL_R16F);
  if (!distance) return distance.error();
  Result<gpu::Texture> shadow = gpu::Texture::create2D("solid shadow", size, GL_R16F);
  if (!shadow) return shadow.error();
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  m_map = gpu::Handle<gpu::FramebufferKind>(name);
  gpu::labelObject(gpu::FramebufferKind::kLabel, name, "solid map");
  m_distance = std::move(*distance);
  m_shadow = std::move(*shadow);
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, m_distance.name(), 0);
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT1, m_shadow.name(), 0);
  const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glNamedFramebufferDrawBuffers(name, 2, both);
  if (glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    return makeError(ErrorKind::Machine, "OpenGL refuses the framebuffer 'solid map'");
  }
  return Done{};
}

Status SolidPass::configure(const std::vector<Obstacle>& obstacles, const FieldSettings& field) {
  const std::vector<Solid> solids = makeSolids(obstacles);
  const glm::vec2 area = solidMapArea(field).size;
  const glm::ivec2 size = glm::max(glm::ivec2(area / std::max(area.x, area.y) * float(kMapSide)), glm::ivec2(16));
  if (Status made = makeMap(size); !made) return made;
  m_count = static_cast<int>(solids.size());
  m_mapFresh = false;
  if (solids.empty()) return Done{};
  Result<gpu::Buffer> buffer = gpu::Buffer::create("solids", std::span<const Solid>(solids));
  if (!buffer) return buffer.error();
  m_solids = std::move(*buffer);
  return Done{};
}

void SolidPass::updateMap() {
  if (m_mapFresh) return;
  m_mapFresh = true;
  const gpu::DebugGroup group("solid map");
  const float far[4] = {kFarM, 0.0f, 0.0f, 0.0f}, none[4] = {-1.0f, 0.0f, 0.0f, 0.0f};
  gpu::apply({.framebuffer = m_map.name(), .viewport = {0, 0, m_distance.size().x, m_distance.size().y}});
  glClearNamedFramebufferfv(m_map.name(), GL_COLOR, 0, far);
  glClearNamedFramebufferfv(m_map.name(), GL_COLOR, 1, none);
  if (m_count == 0) return;
  // The nearest solid and the highest shadow win; PassState knows no such blending.
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBlendEquationi(0, GL_MIN);
  glBlendEquationi(1, GL_MAX);
  m_drawMap->use();
  m_solids.bindStorage(RENDER_SSBO_SOLIDS);
  m_noVertices.bind();
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, m_count);
  glBlendEquation(GL_FUNC_ADD);
}

void SolidPass::bindMap() const {
  m_distance.bind(RENDER_TEXTURE_SOLID_DISTANCE);
  m_shadow.bind(RENDER_TEXTURE_SOLID_SHADOW);
}

void SolidPass::draw(const gpu::PassState& state) const {
  if (m_count == 0) return;
  const gpu::DebugGroup group("solids");
  gpu::apply(state);
  m_draw->use();
  m_solids.bindStorage(RENDER_SSBO_SOLIDS);
  m_noVertices.bind();
  glDrawArraysInstanced(GL_TRIANGLES, 0, kStrips * kSectors * 6, m_count);
}

}  // namespace windloom
