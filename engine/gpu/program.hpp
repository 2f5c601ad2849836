#pragma once
// A linked program. Made and kept by ShaderLibrary, which may put a newer one behind the same object
// when its files change.

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <string_view>

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/handle.hpp"

namespace windloom::gpu {

class Program {
 public:
  Program() = default;

  [[nodiscard]] GLuint name() const { return m_handle.name(); }
  void use() const;

  /// Uniforms by name; locations are cached. As in OpenGL, a name that the program doesn't use is ignored.
  void set(std::string_view uniform, float value) const;
  void set(std::string_view uniform, int value) const;
  void set(std::string_view uniform, unsigned value) const;
  void set(std::string_view uniform, glm::vec2 value) const;
  void set(std::string_view uniform, glm::vec3 value) const;
  void set(std::string_view uniform, glm::vec4 value) const;
  void set(std::string_view uniform, glm::ivec2 value) const;
  void set(std::string_view uniform, glm::ivec3 value) const;
  void set(std::string_view uniform, glm::ivec4 value) const;
  void set(std::string_view uniform, const glm::mat3& value) const;
  void set(std::string_view uniform, const glm::mat4& value) const;
  [[nodiscard]] bool uses(std::string_view uniform) const { return location(uniform) >= 0; }

  /// local_size of a compute program.
  [[nodiscard]] glm::ivec3 workGroupSize() const { return m_workGroupSize; }
  /// Runs a compute program on so many work-groups (all >= 1).
  void dispatch(int x, int y = 1, int z = 1) const;
  /// As dispatch(), the three numbers read by the GPU from `commands` at `offset` bytes; any may be 0. Whoever calls it
  /// issues GL_COMMAND_BARRIER_BIT where a shader wrote them.
  void dispatchIndirect(const Buffer& commands, std::size_t offset) const;
  /// Runs as many work-groups as cover `size` invocations.
  void dispatchOver(glm::ivec2 size) const;

 private:
  friend class ShaderLibrary;
  explicit Program(Handle<ProgramKind> linked);
  [[nodiscard]] GLint location(std::string_view uniform) const;

  Handle<ProgramKind> m_handle;
  glm::ivec3 m_workGroupSize{0};
  mutable std::map<std::string, GLint, std::less<>> m_locations;
  mutable std::map<GLint, int> m_integers;  // what was set
};

}  // namespace windloom::gpu
