#pragma once
// One move-only owner of an OpenGL name for every kind of object.

#include <epoxy/gl.h>

#include <utility>

#include "engine/gpu/bindings.hpp"

namespace windloom::gpu {

/// `Kind` says how names of its kind are deleted. Name 0 owns nothing.
template <class Kind>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint name) : m_name(name) {}
  Handle(Handle&& other) noexcept : m_name(std::exchange(other.m_name, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      reset();
      m_name = std::exchange(other.m_name, 0);
    }
    return *this;
  }
  ~Handle() { reset(); }

  [[nodiscard]] GLuint name() const { return m_name; }
  explicit operator bool() const { return m_name != 0; }

 private:
  void reset() {
    if (m_name != 0) Kind::destroy(m_name);
    m_name = 0;
  }
  GLuint m_name = 0;
};

struct BufferKind {
  static constexpr GLenum kLabel = GL_BUFFER;
  static void destroy(GLuint name) {
    forgetBuffer(name);
    glDeleteBuffers(1, &name);
  }
};
struct TextureKind {
  static constexpr GLenum kLabel = GL_TEXTURE;
  static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct FramebufferKind {
  static constexpr GLenum kLabel = GL_FRAMEBUFFER;
  static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct VertexArrayKind {
  static constexpr GLenum kLabel = GL_VERTEX_ARRAY;
  static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct ProgramKind {
  static constexpr GLenum kLabel = GL_PROGRAM;
  static void destroy(GLuint name) {
    forgetProgram(name);
    glDeleteProgram(name);
  }
};
struct ShaderKind {
  static constexpr GLenum kLabel = GL_SHADER;
  static void destroy(GLuint name) { glDeleteShader(name); }
};
struct QueryKind {
  static constexpr GLenum kLabel = GL_QUERY;
  static void destroy(GLuint name) { glDeleteQueries(1, &name); }
};

}  // namespace windloom::gpu
