#include "engine/gpu/bindings.hpp"

#include <array>

namespace windloom::gpu {
namespace {

struct Bound {
  GLuint buffer = 0;
  GLintptr offset = 0;
  GLsizeiptr bytes = 0;
  bool operator==(const Bound&) const = default;
};

constexpr GLuint kIndices = 32;  // of higher ones nothing is remembered

struct Remembered {
  GLuint program = 0;
  std::array<Bound, kIndices> storage{}, uniform{};
};
thread_local Remembered remembered;

}  // namespace

void bindProgram(GLuint program) {
  if (remembered.program == program) return;
  glUseProgram(program);
  remembered.program = program;
}

void bindIndexed(GLenum target, GLuint index, GLuint buffer, GLintptr offset, GLsizeiptr bytes) {
  const Bound wanted{buffer, offset, bytes};
  if (index < kIndices) {
    Bound& bound = (target == GL_UNIFORM_BUFFER ? remembered.uniform : remembered.storage)[index];
    if (bound == wanted) return;
    bound = wanted;
  }
  if (bytes == 0) {
    glBindBufferBase(target, index, buffer);
  } else {
    glBindBufferRange(target, index, buffer, offset, bytes);
  }
}

void forgetBuffer(GLuint buffer) {
  for (auto* bindings : {&remembered.storage, &remembered.uniform}) {
    for (Bound& bound : *bindings) {
      if (bound.buffer == buffer) bound = {};
    }
  }
}

void forgetProgram(GLuint program) {
  if (remembered.program == program) remembered.program = 0;
}

void forgetBindings() {
  remembered = {};
}

}  // namespace windloom::gpu
