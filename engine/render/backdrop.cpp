#include "engine/render/backdrop.hpp"

#include <algorithm>

#include "engine/gpu/debug_group.hpp"
#include "engine/gpu/object_label.hpp"
#include "engine/render/render_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

constexpr glm::ivec2 kSkySize{2048, 512};
constexpr int kRings = 6, kSectors = 24;  // as in shaders/terrain/ground.vert

}  // namespace

Result<Backdrop> Backdrop::create(gpu::ShaderLibrary& shaders) {
  Backdrop backdrop;
  if (Status loaded = loadPrograms(shaders, {{"sky/bake", &backdrop.m_bake},
                                             {"sky/sky", &backdrop.m_sky},
                                             {"terrain/ground", &backdrop.m_ground[0]},
                                             {"terrain/ground quick", &backdrop.m_ground[1]},
                                             {"terrain/ground plain", &backdrop.m_ground[2]}});
      !loaded) {
    return loaded.error();
  }
  Result<gpu::Texture> sky = gpu::Texture::create2D("sky", kSkySize, GL_RGBA8, {.filter = gpu::Filter::Linear});
  if (!sky) return sky.error();
  backdrop.m_skyMap = std::move(*sky);
  // The azimuth runs round, the elevation doesn't.
  glTextureParameteri(backdrop.m_skyMap.name(), GL_TEXTURE_WRAP_S, GL_REPEAT);
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  backdrop.m_skyTarget = gpu::Handle<gpu::FramebufferKind>(name);
  gpu::labelObject(gpu::FramebufferKind::kLabel, name, "sky");
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, backdrop.m_skyMap.name(), 0);
  backdrop.m_noVertices = gpu::VertexArray::create("backdrop");
  return backdrop;
}

void Backdrop::bakeSky() {
  if (m_baked) return;
  m_baked = true;
  const gpu::DebugGroup group("bake sky");
  gpu::apply({.framebuffer = m_skyTarget.name(), .viewport = {0, 0, kSkySize.x, kSkySize.y}});
  m_bake->use();
  m_noVertices.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Backdrop::drawGround(const gpu::PassState& state, const ViewCamera& camera, GroundDetail detail) const {
  const gpu::DebugGroup group("ground");
  gpu::apply(state);
  const gpu::Program& program = *m_ground[static_cast<std::size_t>(detail)];
  program.use();
  const float reach =
      camera.orthographic ? 4.0f * camera.orthographicHeight + camera.farPlane : 0.98f * camera.farPlane;
  const float rings[kRings] = {0.0f, 0.002f * reach, 0.01f * reach, 0.05f * reach, 0.25f * reach, reach};
  for (int ring = 0; ring < kRings; ++ring) program.set("rings[" + std::to_string(ring) + "]", rings[ring]);
  m_noVertices.bind();
  glDrawArrays(GL_TRIANGLES, 0, (kRings - 1) * kSectors * 6);
}

void Backdrop::drawSky(const gpu::PassState& state) const {
  const gpu::DebugGroup group("sky");
  gpu::apply(state);
  m_sky->use();
  m_skyMap.bind(RENDER_TEXTURE_SKY);
  m_noVertices.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace windloom
