#include "engine/render/occluders.hpp"

#include <epoxy/gl.h>

#include <algorithm>

#include "engine/gpu/debug_group.hpp"
#include "engine/render/render_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {

Result<Occluders> Occluders::create(gpu::ShaderLibrary& shaders, glm::ivec2 size) {
  Result<gpu::Program*> reduce = shaders.load(renderProgram("terrain/occluder level"));
  if (!reduce) return reduce.error();
  Result<gpu::Framebuffer> depths =
      gpu::Framebuffer::create("occluders", size, {.colour = 0, .depth = GL_DEPTH_COMPONENT32F});
  if (!depths) return depths.error();
  Result<gpu::Texture> pyramid =
      gpu::Texture::create2D("occluder pyramid", size, GL_R32F, {.levels = 0, .filter = gpu::Filter::Nearest});
  if (!pyramid) return pyramid.error();
  Occluders occluders;
  occluders.m_reduce = *reduce;
  occluders.m_depths = std::move(*depths);
  occluders.m_pyramid = std::move(*pyramid);
  occluders.m_size = size;
  for (int side = std::max(size.x, size.y); side > 0; side /= 2) ++occluders.m_levels;
  // Texels of a level are read as they are, never between two levels.
  glTextureParameteri(occluders.m_pyramid.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  return occluders;
}

void Occluders::update(const std::function<void(const gpu::PassState&)>& drawOccluders) {
  const gpu::DebugGroup group("occluders");
  m_depths.clearDepth(1.0f);
  drawOccluders(
      {.framebuffer = m_depths.name(), .viewport = {0, 0, m_size.x, m_size.y}, .depth = gpu::Depth::TestAndWrite});
  m_reduce->use();
  for (int level = 0; level < m_levels; ++level) {
    const glm::ivec2 size = glm::max(m_size >> level, glm::ivec2(1));
    glBindTextureUnit(RENDER_TEXTURE_OCCLUDERS, level == 0 ? m_depths.depth().name() : m_pyramid.name());
    glBindImageTexture(0, m_pyramid.name(), level, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    m_reduce->set("level", level);
    m_reduce->dispatchOver(size);
    // The next level, and the culling, read what this one wrote.
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  }
  bind();
}

void Occluders::bind() const {
  glBindTextureUnit(RENDER_TEXTURE_OCCLUDERS, m_pyramid.name());
}

}  // namespace windloom
