#include "engine/gpu/vertex_array.hpp"

#include "engine/gpu/object_label.hpp"

namespace windloom::gpu {

VertexArray VertexArray::create(std::string_view label) {
  VertexArray array;
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  array.m_handle = Handle<VertexArrayKind>(name);
  labelObject(VertexArrayKind::kLabel, name, label);
  return array;
}

void VertexArray::bind() const {
  glBindVertexArray(name());
}

void VertexArray::vertexBuffer(unsigned binding, const Buffer& buffer, int strideBytes, unsigned divisor,
                               std::size_t offset) {
  glVertexArrayVertexBuffer(name(), binding, buffer.name(), static_cast<GLintptr>(offset), strideBytes);
  glVertexArrayBindingDivisor(name(), binding, divisor);
}

void VertexArray::floats(unsigned location, unsigned binding, int components, unsigned offsetBytes) {
  glEnableVertexArrayAttrib(name(), location);
  glVertexArrayAttribFormat(name(), location, components, GL_FLOAT, GL_FALSE, offsetBytes);
  glVertexArrayAttribBinding(name(), location, binding);
}

void VertexArray::unitBytes(unsigned location, unsigned binding, int components, unsigned offsetBytes) {
  glEnableVertexArrayAttrib(name(), location);
  glVertexArrayAttribFormat(name(), location, components, GL_UNSIGNED_BYTE, GL_TRUE, offsetBytes);
  glVertexArrayAttribBinding(name(), location, binding);
}

void VertexArray::uints(unsigned location, unsigned binding, int components, unsigned offsetBytes) {
  glEnableVertexArrayAttrib(name(), location);
  glVertexArrayAttribIFormat(name(), location, components, GL_UNSIGNED_INT, offsetBytes);
  glVertexArrayAttribBinding(name(), location, binding);
}

void VertexArray::indexBuffer(const Buffer& buffer) {
  glVertexArrayElementBuffer(name(), buffer.name());
}

}  // namespace windloom::gpu
