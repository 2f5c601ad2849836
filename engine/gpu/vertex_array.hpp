#pragma once
// Which buffers and layouts a draw reads its vertices from. An empty one serves draws whose vertex shader
// makes everything from gl_VertexID and gl_InstanceID.

#include <string_view>

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/handle.hpp"

namespace windloom::gpu {

class VertexArray {
 public:
  VertexArray() = default;
  static VertexArray create(std::string_view label);

  [[nodiscard]] GLuint name() const { return m_handle.name(); }
  void bind() const;

  /// Slot `binding` reads `buffer` with `stride` bytes a vertex, or an instance where divisor is 1.
  void vertexBuffer(unsigned binding, const Buffer& buffer, int strideBytes, unsigned divisor = 0,
                    std::size_t offset = 0);
  /// Attribute `location` takes `components` floats at `offset` of slot `binding`.
  void floats(unsigned location, unsigned binding, int components, unsigned offsetBytes);
  /// As floats(), from bytes that mean 0..1.
  void unitBytes(unsigned location, unsigned binding, int components, unsigned offsetBytes);
  /// As floats(), from 32-bit unsigned integers that stay integers.
  void uints(unsigned location, unsigned binding, int components, unsigned offsetBytes);
  void indexBuffer(const Buffer& buffer);

 private:
  Handle<VertexArrayKind> m_handle;
};

}  // namespace windloom::gpu
