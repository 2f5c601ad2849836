#include "gl_objects.hpp"

#include <cstdio>
#include <cstdlib>

namespace game {

namespace {

GLuint compile(const char* name, GLenum stage, const std::string& text) {
  const GLuint shader = glCreateShader(stage);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint done = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done == 0) {
    char log[4096] = "";
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    std::fprintf(stderr, "windloom-leaves: the shader of %s doesn't compile:\n%s\n", name, log);
    std::exit(3);  // a fault of the driver or of this game, nothing that a player can mend
  }
  return shader;
}

}  // namespace

void freeBuffer(GLuint name) {
  glDeleteBuffers(1, &name);
}
void freeVertexArray(GLuint name) {
  glDeleteVertexArrays(1, &name);
}
void freeTexture(GLuint name) {
  glDeleteTextures(1, &name);
}
void freeFramebuffer(GLuint name) {
  glDeleteFramebuffers(1, &name);
}
void freeRenderbuffer(GLuint name) {
  glDeleteRenderbuffers(1, &name);
}
void freeProgram(GLuint name) {
  glDeleteProgram(name);
}

Buffer makeBuffer(GLenum target, const void* data, std::size_t bytes, GLenum usage) {
  GLuint name = 0;
  glGenBuffers(1, &name);
  glBindBuffer(target, name);
  glBufferData(target, static_cast<GLsizeiptr>(bytes), data, usage);
  return Buffer(name);
}

void refillBuffer(const Buffer& buffer, const void* data, std::size_t bytes) {
  glBindBuffer(GL_ARRAY_BUFFER, *buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_STREAM_DRAW);
}

VertexArray makeVertexArray() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  glBindVertexArray(name);
  return VertexArray(name);
}

void vertexInput(GLuint location, int floats, int stride, int offset, bool perInstance) {
  constexpr auto kFloat = static_cast<GLsizei>(sizeof(float));
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, floats, GL_FLOAT, GL_FALSE, stride * kFloat,
                        reinterpret_cast<const void*>(static_cast<std::uintptr_t>(offset) * sizeof(float)));
  glVertexAttribDivisor(location, perInstance ? 1 : 0);
}

Texture makeByteTexture(int side, int channels, const std::vector<unsigned char>& texels) {
  const GLenum formats[] = {0, GL_RED, GL_RG, 0, GL_RGBA};
  const GLint stored[] = {0, GL_R8, GL_RG8, 0, GL_RGBA8};
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, stored[channels], side, side, 0, formats[channels], GL_UNSIGNED_BYTE, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glGenerateMipmap(GL_TEXTURE_2D);
  return Texture(name);
}

Program::Program(const char* name, const std::string& shared, const char* vertex, const char* fragment)
    : m_name(glCreateProgram()) {
  const GLuint stages[] = {compile(name, GL_VERTEX_SHADER, shared + vertex),
                           compile(name, GL_FRAGMENT_SHADER, shared + fragment)};
  for (const GLuint stage : stages) glAttachShader(*m_name, stage);
  glLinkProgram(*m_name);
  for (const GLuint stage : stages) glDeleteShader(stage);
  GLint done = 0;
  glGetProgramiv(*m_name, GL_LINK_STATUS, &done);
  if (done == 0) {
    char log[4096] = "";
    glGetProgramInfoLog(*m_name, sizeof log, nullptr, log);
    std::fprintf(stderr, "windloom-leaves: the program of %s doesn't link:\n%s\n", name, log);
    std::exit(3);
  }
}

}  // namespace game
