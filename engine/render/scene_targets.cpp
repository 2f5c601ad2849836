#include "engine/render/scene_targets.hpp"

#include <string>

#include "engine/gpu/object_label.hpp"

namespace windloom {
namespace {

Result<gpu::Texture> attachment(std::string_view label, glm::ivec2 size, GLenum format, int samples) {
  if (samples > 1) return gpu::Texture::createMultisampled(label, size, format, samples);
  return gpu::Texture::create2D(label, size, format, {.filter = gpu::Filter::Nearest});
}

Result<gpu::Handle<gpu::FramebufferKind>> framebuffer(std::string_view label, const gpu::Texture& colour, const gpu::Texture& depth) {
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  gpu::Handle<gpu::FramebufferKind> handle(name);
  gpu::labelObject(gpu::FramebufferKind::kLabel, name, label);
  glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, colour.name(), 0);
  glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT, depth.name(), 0);
  if (const GLenum state = glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER); state != GL_FRAMEBUFFER_COMPLETE) {
    return makeError(ErrorKind::Machine, "OpenGL refuses the framebuffer '" + std::string(label) + "' (status " + std::to_string(state) + ")");
  }
  return handle;
}

}  // namespace

Result<SceneTargets> SceneTargets::create(glm::ivec2 size, int samples) {
  SceneTargets targets;
  targets.m_size = size;
  targets.m_samples = samples;
  Result<gpu::Texture> light = attachment("scene light", size, GL_RGBA16F, samples);
  if (!light) return light.error();
  Result<gpu::Texture> over = attachment("overlay", size, GL_RGBA8, samples);
  if (!over) return over.error();
  Result<gpu::Texture> depth = attachment("scene depth", size, GL_DEPTH_COMPONENT32F, samples);
  if (!depth) return depth.error();
  targets.m_light = std::move(*light);
  targets.m_overlayColour = std::move(*over);
  targets.m_depth = std::move(*depth);
  auto scene = framebuffer("scene", targets.m_light, targets.m_depth);
  if (!scene) return scene.error();
  auto overlay = framebuffer("overlay", targets.m_overlayColour, targets.m_depth);
  if (!overlay) return overlay.error();
  targets.m_scene = std::move(*scene);
  targets.m_overlay = std::move(*overlay);
  return targets;
}

void SceneTargets::clearScene() const {
  const float far = 1.0f;
  glClearNamedFramebufferfv(scene(), GL_DEPTH, 0, &far);
}

void SceneTargets::clearOverlay() const {
  const glm::vec4 nothing(0.0f);
  glClearNamedFramebufferfv(overlay(), GL_COLOR, 0, &nothing.x);
}

}  // namespace windloom
