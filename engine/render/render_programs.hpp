#pragma once
// The programs of this room.

#include <span>

#include "engine/gpu/shader_library.hpp"

namespace windloom {

/// Every program and variant: the passes load from this table, a test compiles all of it.
std::span<const gpu::ProgramSpec> renderPrograms();

/// The one with this name; the name must be in the table.
const gpu::ProgramSpec& renderProgram(std::string_view name);

/// Loads the named programs into the given places. Fails with Machine.
Status loadPrograms(gpu::ShaderLibrary& shaders, std::initializer_list<std::pair<std::string_view, gpu::Program**>> wanted);

}  // namespace windloom
