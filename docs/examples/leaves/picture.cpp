#include "picture.hpp"

namespace game {

namespace {

Renderbuffer attach(GLenum place, GLenum format, int width, int height, int samples) {
  GLuint name = 0;
  glGenRenderbuffers(1, &name);
  glBindRenderbuffer(GL_RENDERBUFFER, name);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, name);
  return Renderbuffer(name);
}

Framebuffer makeFramebuffer() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
  return Framebuffer(name);
}

}  // namespace

void Picture::begin(int width, int height, int samples) {
  if (width != m_width || height != m_height || samples != m_samples) {
    m_target = makeFramebuffer();
    m_colour = attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height, samples);
    m_depth = attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height, samples);
    m_joined = makeFramebuffer();
    m_joinedColour = attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height, 1);
    m_width = width;
    m_height = height;
    m_samples = samples;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, *m_target);
  glViewport(0, 0, width, height);
}

/// Samples are joined into another picture first: OpenGL 3.3 joins only into one of the very same format, which the
/// window's needn't be.
void Picture::show() {
  const bool join = m_samples > 1;
  if (join) copy(*m_target, *m_joined);
  copy(join ? *m_joined : *m_target, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Picture::copy(GLuint from, GLuint to) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  glBlitFramebuffer(0, 0, m_width, m_height, 0, 0, m_width, m_height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

}  // namespace game
