// Runs a fragment shader over a square and writes what it gives: run_fragment SHADER.frag OUT SIDE TEXTURE...
// The shader gets `layout(location = 0) in vec2` from (0, 0) to (1, 1), with the first row of OUT (SIDE x SIDE bytes of
// RGBA) at v = 0. Textures go to units 0, 1, ...: rgba8:FILE:W:H or rg16f:FILE:W:H:LAYERS (an array), raw bytes; they
// are sampled linearly and repeat. Exit status 1 with the compiler's words where something is wrong.
#include <epoxy/gl.h>

#include <cstdio>
#include <sstream>

#include "engine/core/file.hpp"
#include "engine/gpu/context.hpp"

namespace {

using namespace windloom;

constexpr const char* kVertex = R"(#version 450
layout(location = 0) out vec2 place;
void main() {
  place = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);
}
)";

GLuint compiled(GLenum stage, const std::string& text) {
  const GLuint shader = glCreateShader(stage);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint done = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done) return shader;
  char words[4096] = "";
  glGetShaderInfoLog(shader, sizeof words, nullptr, words);
  std::fprintf(stderr, "%s\n", words);
  return 0;
}

GLuint linked(const std::string& fragment) {
  const GLuint program = glCreateProgram();
  for (const auto& [stage, text] : {std::pair(GL_VERTEX_SHADER, std::string(kVertex)), {GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = compiled(static_cast<GLenum>(stage), text);
    if (shader == 0) return 0;
    glAttachShader(program, shader);
  }
  glLinkProgram(program);
  GLint done = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &done);
  return done ? program : 0;
}

/// KIND:FILE:W:H[:LAYERS] into texture unit `unit`.
bool bindTexture(GLuint unit, const std::string& text) {
  std::istringstream words(text);
  std::string kind, file, number;
  std::getline(words, kind, ':');
  std::getline(words, file, ':');
  int size[3] = {0, 0, 1};
  for (int& side : size) {
    if (std::getline(words, number, ':')) side = std::stoi(number);
  }
  const Result<std::string> bytes = readFile(file);
  const bool half = kind == "rg16f";
  const auto expected = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1] * size[2] * 4);
  if (!bytes || bytes->size() != expected) return false;
  const GLenum target = half ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
  GLuint texture = 0;
  glCreateTextures(target, 1, &texture);
  if (half) {
    glTextureStorage3D(texture, 1, GL_RG16F, size[0], size[1], size[2]);
    glTextureSubImage3D(texture, 0, 0, 0, 0, size[0], size[1], size[2], GL_RG, GL_HALF_FLOAT, bytes->data());
  } else {
    glTextureStorage2D(texture, 1, GL_RGBA8, size[0], size[1]);
    glTextureSubImage2D(texture, 0, 0, 0, size[0], size[1], GL_RGBA, GL_UNSIGNED_BYTE, bytes->data());
  }
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glBindTextureUnit(unit, texture);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const Result<std::unique_ptr<gpu::Context>> context = gpu::createOffscreenContext();
  const Result<std::string> fragment = readFile(argv[1]);
  if (!context || !fragment) {
    std::fprintf(stderr, "%s\n", (context ? fragment.error() : context.error()).text().c_str());
    return 1;
  }
  const GLuint program = linked(*fragment);
  if (program == 0) return 1;
  const int side = std::stoi(argv[3]);
  for (int i = 4; i < argc; ++i) {
    if (bindTexture(static_cast<GLuint>(i - 4), argv[i])) continue;
    std::fprintf(stderr, "%s: no such texture, or of another size\n", argv[i]);
    return 1;
  }
  GLuint target = 0, framebuffer = 0, vertices = 0;
  glCreateRenderbuffers(1, &target);
  glNamedRenderbufferStorage(target, GL_RGBA8, side, side);
  glCreateFramebuffers(1, &framebuffer);
  glNamedFramebufferRenderbuffer(framebuffer, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
  glCreateVertexArrays(1, &vertices);
  glBindVertexArray(vertices);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, side, side);
  glUseProgram(program);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  std::string out(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 4, '\0');
  glReadPixels(0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE, out.data());
  const Status written = writeFileAtomically(argv[2], out);
  return written && glGetError() == GL_NO_ERROR ? 0 : 1;
}
