#pragma once
// The programs of the GPU backend: one table of all variants.

#include <span>

#include "engine/gpu/shader_library.hpp"

namespace windloom {

/// Every variant, for the test that compiles all. Those of the tail have example sizes.
std::span<const gpu::ProgramSpec> windPrograms();

/// The variant with this name; asking for another one is a broken promise.
const gpu::ProgramSpec& windProgram(std::string_view name);

}  // namespace windloom
