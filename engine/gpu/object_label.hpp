#pragma once
// Names an OpenGL object for debuggers and driver messages.

#include <epoxy/gl.h>

#include <string_view>

namespace windloom::gpu {

/// The object must exist (made by glCreate*, or bound once).
inline void labelObject(GLenum kind, GLuint name, std::string_view label) {
  glObjectLabel(kind, name, static_cast<GLsizei>(label.size()), label.data());
}

/// Forgets errors of earlier calls, so that the next glGetError speaks of what follows.
inline void forgetErrors() {
  for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
  }
}

}  // namespace windloom::gpu
