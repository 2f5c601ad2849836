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

/// The lowest ground along the outline and at the centre.
float footOf(const Solid& solid, const HeightField& ground) {
  const glm::vec2 centre(solid.place), half(solid.place.z, solid.place.w);
  float lowest = heightAt(ground, centre);
  for (int sector = 0; sector < kSectors; ++sector) {
    const float turn = 6.2831853f * static_cast<float>(sector) / static_cast<float>(kSectors);
    glm::vec2 local(std::cos(turn), std::sin(turn));
    if (solid.shape.w == SOLID_BOX) local /= std::max(std::abs(local.x), std::abs(local.y));
    local *= half;
    const glm::vec2 at(solid.shape.x * local.x - solid.shape.y * local.y, solid.shape.y * local.x + solid.shape.x * local.y);
    lowest = std::min(lowest, heightAt(ground, centre + at));
  }
  return lowest;
}

}  // namespace

std::vector<Solid> makeSolids(const std::vector<Obstacle>& obstacles, const HeightField* ground) {
  std::vector<Solid> solids;
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.hidden) continue;
    const bool circle = obstacle.shape == ObstacleShape::Circle;
    const glm::vec2 half = circle ? glm::vec2(obstacle.radius) : 0.5f * obstacle.size;
    const float turn = circle ? 0.0f : glm::radians(obstacle.rotation);
    solids.push_back({{obstacle.centre, half}, {std::cos(turn), std::sin(turn), obstacle.height, circle ? SOLID_CIRCLE : SOLID_BOX}, {0.0f, obstacle.height, 0.0f, 0.0f}});
    if (ground == nullptr) continue;
    Solid& solid = solids.back();
    solid.level = {footOf(solid, *ground), heightAt(*ground, obstacle.centre) + obstacle.height, 0.0f, 0.0f};
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

Status SolidPass::configure(const std::vector<Obstacle>& obstacles, const FieldSettings& field, const HeightField* ground) {
  const std::vector<Solid> solids = makeSolids(obstacles, ground);
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
  m_noVertices.bind();
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, m_count);
  glBlendEquation(GL_FUNC_ADD);
}

void SolidPass::bindMap() const { m_mapTexture.bind(RENDER_TEXTURE_SOLIDS); }

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
