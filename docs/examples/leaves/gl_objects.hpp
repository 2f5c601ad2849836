#pragma once
// OpenGL names that free themselves, and the few helpers that this game draws with.

#include <epoxy/gl.h>

#include <string>
#include <utility>
#include <vector>

#include "maths.hpp"

namespace game {

/// Owns one OpenGL name; move-only.
template <void (*free)(GLuint)>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint name) : m_name(name) {}
  GlName(GlName&& other) noexcept : m_name(std::exchange(other.m_name, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(m_name, other.m_name);
    return *this;
  }
  ~GlName() {
    if (m_name != 0) free(m_name);
  }
  GLuint operator*() const { return m_name; }

 private:
  GLuint m_name = 0;
};

void freeBuffer(GLuint name);
void freeVertexArray(GLuint name);
void freeTexture(GLuint name);
void freeFramebuffer(GLuint name);
void freeRenderbuffer(GLuint name);
void freeProgram(GLuint name);
using Buffer = GlName<freeBuffer>;
using VertexArray = GlName<freeVertexArray>;
using Texture = GlName<freeTexture>;
using Framebuffer = GlName<freeFramebuffer>;
using Renderbuffer = GlName<freeRenderbuffer>;

/// A buffer with `bytes` of data, or that much room where `data` is null.
Buffer makeBuffer(GLenum target, const void* data, std::size_t bytes, GLenum usage);
/// New content for a buffer that is filled anew each frame. It never waits for the GPU to be done with the old one.
void refillBuffer(const Buffer& buffer, const void* data, std::size_t bytes);
VertexArray makeVertexArray();
/// Numbers of the buffer bound to GL_ARRAY_BUFFER as input `location` of the bound vertex array; all in floats.
void vertexInput(GLuint location, int floats, int stride, int offset, bool perInstance = false);
/// `channels` 1, 2 or 4; bytes are 0..1 in the shader. It repeats and has mipmaps.
Texture makeByteTexture(int side, int channels, const std::vector<unsigned char>& texels);

/// A vertex and a fragment shader, each after the text that they share.
class Program {
 public:
  Program(const char* name, const std::string& shared, const char* vertex, const char* fragment);
  void use() const { glUseProgram(*m_name); }
  void set(const char* uniform, float value) const { glUniform1f(place(uniform), value); }
  void set(const char* uniform, int value) const { glUniform1i(place(uniform), value); }
  void set(const char* uniform, Vec3 value) const { glUniform3f(place(uniform), value.x, value.y, value.z); }
  void set(const char* uniform, float a, float b, float c, float d) const { glUniform4f(place(uniform), a, b, c, d); }
  void set(const char* uniform, const Mat4& value) const {
    glUniformMatrix4fv(place(uniform), 1, GL_FALSE, value.data());
  }

 private:
  /// -1, which OpenGL ignores, where the shader doesn't use it.
  GLint place(const char* uniform) const { return glGetUniformLocation(*m_name, uniform); }
  GlName<freeProgram> m_name;
};

}  // namespace game
