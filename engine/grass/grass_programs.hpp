#pragma once
// The programs of this room.

#include <span>

#include "engine/gpu/shader_library.hpp"

namespace windloom {

/// Every program and variant: the renderer loads from this table, a test compiles all of it.
std::span<const gpu::ProgramSpec> grassPrograms();

/// The one with this name; the name must be in the table.
const gpu::ProgramSpec& grassProgram(std::string_view name);

}  // namespace windloom
