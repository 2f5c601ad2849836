#include "engine/gpu/buffer.hpp"

#include <string>
#include <vector>

#include "engine/core/log.hpp"
#include "engine/gpu/memory_failure.hpp"
#include "engine/gpu/object_label.hpp"

namespace windloom::gpu {

Result<Buffer> Buffer::create(std::string_view label, std::size_t bytes, BufferUse use, const void* data) {
  WL_REQUIRE(bytes > 0, "a buffer holds something");
  Buffer buffer;
  GLuint name = 0;
  glCreateBuffers(1, &name);
  buffer.m_handle = Handle<BufferKind>(name);
  buffer.m_bytes = bytes;
  buffer.m_use = use;
  labelObject(BufferKind::kLabel, name, label);
  // A dynamic buffer starts from zeros of the CPU: after a clear on the GPU, NVIDIA's driver (580.159) loses a write of
  // 100 KB that follows at once.
  std::vector<char> zeros;
  if (data == nullptr && use == BufferUse::Dynamic) {
    zeros.resize(bytes);
    data = zeros.data();
  }
  forgetErrors();
  glNamedBufferStorage(name, static_cast<GLsizeiptr>(bytes), data,
                       use == BufferUse::Dynamic ? GL_DYNAMIC_STORAGE_BIT : 0);
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    return memoryFailure("OpenGL has no memory for the buffer '" + std::string(label) + "' of " +
                         std::to_string(bytes) + " bytes");
  }
  buffer.m_memory = MemoryUse(label, bytes);
  if (data == nullptr) buffer.clear();
  return buffer;
}

void Buffer::write(const void* data, std::size_t bytes, std::size_t offset) {
  WL_REQUIRE(m_use == BufferUse::Dynamic, "only a dynamic buffer is written from the CPU");
  WL_REQUIRE(offset + bytes <= m_bytes, "the write lies inside the buffer");
  if (bytes == 0) return;
  // Not glNamedBufferSubData: with it NVIDIA's driver (580.159) lets compute work that is still under way see the new
  // bytes, or loses them. A copy takes its place in the queue.
  GLuint staging = 0;
  glCreateBuffers(1, &staging);
  labelObject(BufferKind::kLabel, staging, "staging");
  forgetErrors();
  glNamedBufferStorage(staging, static_cast<GLsizeiptr>(bytes), data, 0);
  if (glGetError() != GL_NO_ERROR)
    logError(memoryFailure("OpenGL has no memory to write " + std::to_string(bytes) + " bytes").text());
  glCopyNamedBufferSubData(staging, name(), 0, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes));
  glDeleteBuffers(1, &staging);
}

void Buffer::clear() {
  if (m_bytes % 4 == 0) {
    glClearNamedBufferData(name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
  } else {
    glClearNamedBufferData(name(), GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
  }
}

void Buffer::read(void* data, std::size_t bytes, std::size_t offset) const {
  WL_REQUIRE(offset + bytes <= m_bytes, "the read lies inside the buffer");
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes), data);
}

void Buffer::bindStorage(unsigned binding) const {
  bindIndexed(GL_SHADER_STORAGE_BUFFER, binding, name());
}
void Buffer::bindUniform(unsigned binding) const {
  bindIndexed(GL_UNIFORM_BUFFER, binding, name());
}

void Buffer::bindUniformRange(unsigned binding, std::size_t offset, std::size_t bytes) const {
  WL_REQUIRE(offset % 256 == 0 && offset + bytes <= m_bytes, "the range is aligned and lies inside the buffer");
  bindIndexed(GL_UNIFORM_BUFFER, binding, name(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes));
}

}  // namespace windloom::gpu
