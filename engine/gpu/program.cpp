#include "engine/gpu/program.hpp"

#include <glm/gtc/type_ptr.hpp>

#include "engine/core/contract.hpp"

namespace windloom::gpu {

Program::Program(Handle<ProgramKind> linked) : m_handle(std::move(linked)) {
  GLint kind[3] = {0, 0, 0};
  GLuint attached[4];
  GLsizei count = 0;
  glGetAttachedShaders(name(), 4, &count, attached);
  GLint type = 0;
  if (count == 1) glGetShaderiv(attached[0], GL_SHADER_TYPE, &type);
  if (type == GL_COMPUTE_SHADER) glGetProgramiv(name(), GL_COMPUTE_WORK_GROUP_SIZE, kind);
  m_workGroupSize = {kind[0], kind[1], kind[2]};
}

void Program::use() const {
  bindProgram(name());
}

GLint Program::location(std::string_view uniform) const {
  const auto known = m_locations.find(uniform);
  if (known != m_locations.end()) return known->second;
  std::string text(uniform);
  const GLint found = glGetUniformLocation(name(), text.c_str());
  m_locations.emplace(std::move(text), found);
  return found;
}

void Program::set(std::string_view uniform, float value) const {
  glProgramUniform1f(name(), location(uniform), value);
}
void Program::set(std::string_view uniform, int value) const {
  const GLint where = location(uniform);
  const auto [known, isNew] = m_integers.try_emplace(where, value);
  if (!isNew && known->second == value) return;  // as with bindings: the same again should cost nothing
  known->second = value;
  glProgramUniform1i(name(), where, value);
}
void Program::set(std::string_view uniform, unsigned value) const {
  glProgramUniform1ui(name(), location(uniform), value);
}
void Program::set(std::string_view uniform, glm::vec2 value) const {
  glProgramUniform2fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, glm::vec3 value) const {
  glProgramUniform3fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, glm::vec4 value) const {
  glProgramUniform4fv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, glm::ivec2 value) const {
  glProgramUniform2iv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, glm::ivec3 value) const {
  glProgramUniform3iv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, glm::ivec4 value) const {
  glProgramUniform4iv(name(), location(uniform), 1, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::mat3& value) const {
  glProgramUniformMatrix3fv(name(), location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(std::string_view uniform, const glm::mat4& value) const {
  glProgramUniformMatrix4fv(name(), location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}

void Program::dispatch(int x, int y, int z) const {
  WL_REQUIRE(x > 0 && y > 0 && z > 0 && m_workGroupSize.x > 0, "a compute program runs on at least one work-group");
  use();
  glDispatchCompute(static_cast<GLuint>(x), static_cast<GLuint>(y), static_cast<GLuint>(z));
}

void Program::dispatchIndirect(const Buffer& commands, std::size_t offset) const {
  use();
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, commands.name());
  glDispatchComputeIndirect(static_cast<GLintptr>(offset));
}

void Program::dispatchOver(glm::ivec2 size) const {
  const glm::ivec2 group(m_workGroupSize.x, m_workGroupSize.y);
  const glm::ivec2 groups = (size + group - 1) / group;
  dispatch(groups.x, groups.y);
}

}  // namespace windloom::gpu
