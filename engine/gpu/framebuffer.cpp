#include "engine/gpu/framebuffer.hpp"

#include <algorithm>
#include <cstring>
#include <string>

#include "engine/gpu/object_label.hpp"

namespace windloom::gpu {
namespace {

Result<Texture> makeAttachment(const std::string& label, glm::ivec2 size, GLenum format, int samples) {
  if (samples > 1) return Texture::createMultisampled(label, size, format, samples);
  return Texture::create2D(label, size, format, {.filter = Filter::Linear});
}

GLenum depthAttachment(GLenum format) {
  const bool stencil = format == GL_DEPTH24_STENCIL8 || format == GL_DEPTH32F_STENCIL8;
  return stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
}

int limitSamples(int wanted) {
  GLint limit = 1, colourLimit = 1, depthLimit = 1;
  glGetIntegerv(GL_MAX_SAMPLES, &limit);
  glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &colourLimit);
  glGetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &depthLimit);
  return std::clamp(wanted, 1, std::max(1, std::min({limit, colourLimit, depthLimit})));
}

/// Clears and blits obey the scissor and masks of whatever pass came before.
void openScissorAndMasks() {
  glDisable(GL_SCISSOR_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
}

}  // namespace

Result<Framebuffer> Framebuffer::create(std::string_view label, glm::ivec2 size, const FramebufferOptions& options) {
  Framebuffer target;
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  target.m_handle = Handle<FramebufferKind>(name);
  target.m_size = size;
  target.m_samples = limitSamples(options.samples);
  labelObject(FramebufferKind::kLabel, name, label);
  if (options.colour != 0) {
    Result<Texture> colour = makeAttachment(std::string(label) + " colour", size, options.colour, target.m_samples);
    if (!colour) return colour.error();
    target.m_colour = std::move(*colour);
    glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0, target.m_colour.name(), 0);
  }
  if (options.depth != 0) {
    Result<Texture> depth = makeAttachment(std::string(label) + " depth", size, options.depth, target.m_samples);
    if (!depth) return depth.error();
    target.m_depth = std::move(*depth);
    glNamedFramebufferTexture(name, depthAttachment(options.depth), target.m_depth.name(), 0);
  }
  if (const GLenum state = glCheckNamedFramebufferStatus(name, GL_DRAW_FRAMEBUFFER); state != GL_FRAMEBUFFER_COMPLETE) {
    return makeError(ErrorKind::Machine, "OpenGL refuses the framebuffer '" + std::string(label) + "' (status " +
                                             std::to_string(state) + ")");
  }
  return target;
}

void Framebuffer::clearColour(glm::vec4 value) const {
  openScissorAndMasks();
  glClearNamedFramebufferfv(name(), GL_COLOR, 0, &value.x);
}

void Framebuffer::clearDepth(float value) const {
  openScissorAndMasks();
  glClearNamedFramebufferfv(name(), GL_DEPTH, 0, &value);
}

void Framebuffer::resolveColour(GLuint target, glm::ivec2 origin) const {
  openScissorAndMasks();
  glBlitNamedFramebuffer(name(), target, 0, 0, m_size.x, m_size.y, origin.x, origin.y, origin.x + m_size.x,
                         origin.y + m_size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Framebuffer::resolveTo(const Framebuffer& target) const {
  WL_REQUIRE(target.m_size == m_size, "resolving keeps the size");
  openScissorAndMasks();
  const bool depth = m_depth.name() != 0 && target.m_depth.name() != 0;
  glBlitNamedFramebuffer(name(), target.name(), 0, 0, m_size.x, m_size.y, 0, 0, m_size.x, m_size.y,
                         GL_COLOR_BUFFER_BIT | (depth ? GL_DEPTH_BUFFER_BIT : 0), GL_NEAREST);
}

std::vector<unsigned char> Framebuffer::readRgba8() const {
  WL_REQUIRE(m_samples == 1, "resolve before reading");
  const std::size_t row = static_cast<std::size_t>(m_size.x) * 4;
  std::vector<unsigned char> bottomUp(row * static_cast<std::size_t>(m_size.y)), pixels(bottomUp.size());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadnPixels(0, 0, m_size.x, m_size.y, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(bottomUp.size()),
                bottomUp.data());
  for (std::size_t y = 0; y < static_cast<std::size_t>(m_size.y); ++y) {
    std::memcpy(&pixels[y * row], &bottomUp[(static_cast<std::size_t>(m_size.y) - 1 - y) * row], row);
  }
  return pixels;
}

}  // namespace windloom::gpu
