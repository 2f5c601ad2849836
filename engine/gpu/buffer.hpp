#pragma once
// A buffer with immutable storage. To resize, make a new one.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/result.hpp"
#include "engine/gpu/handle.hpp"
#include "engine/gpu/memory.hpp"

namespace windloom::gpu {

enum class BufferUse {
  Static,   ///< filled at creation or by shaders; write() is refused
  Dynamic,  ///< write() from the CPU now and then
};

class Buffer {
 public:
  Buffer() = default;

  /// `bytes` > 0; `data`, where given, holds so many bytes, otherwise the contents are zero. Fails with
  /// Machine where there is no memory for it.
  static Result<Buffer> create(std::string_view label, std::size_t bytes, BufferUse use, const void* data = nullptr);

  template <class T>
  static Result<Buffer> create(std::string_view label, std::span<const T> values, BufferUse use = BufferUse::Static) {
    return create(label, values.size_bytes(), use, values.data());
  }

  [[nodiscard]] GLuint name() const { return m_handle.name(); }
  [[nodiscard]] std::size_t bytes() const { return m_bytes; }

  void write(const void* data, std::size_t bytes, std::size_t offset = 0);
  template <class T>
  void write(std::span<const T> values, std::size_t offsetBytes = 0) {
    write(values.data(), values.size_bytes(), offsetBytes);
  }
  /// Fills it with zero bytes on the GPU.
  void clear();
  /// Waits for the GPU; for tests and exports only. Issues the barrier for shader writes itself.
  void read(void* data, std::size_t bytes, std::size_t offset = 0) const;

  void bindStorage(unsigned binding) const;
  void bindUniform(unsigned binding) const;
  /// A part of it; `offset` is a multiple of 256.
  void bindUniformRange(unsigned binding, std::size_t offset, std::size_t bytes) const;

 private:
  Handle<BufferKind> m_handle;
  MemoryUse m_memory;
  std::size_t m_bytes = 0;
  BufferUse m_use = BufferUse::Static;
};

}  // namespace windloom::gpu
