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

}  // namespace

void Picture::begin(int width, int height, int samples) {
  if (width != m_width || height != m_height || samples != m_samples) {
    GLuint target = 0;
    glGenFramebuffers(1, &target);
    m_target = Framebuffer(target);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    m_colour = attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height, samples);
    m_depth = attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height, samples);
    m_width = width;
    m_height = height;
    m_samples = samples;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, *m_target);
  glViewport(0, 0, width, height);
}

void Picture::show() {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, *m_target);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, m_width, m_height, 0, 0, m_width, m_height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace game
