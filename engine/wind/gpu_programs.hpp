#pragma once
// The programs of the GPU backend: one table of all variants.

#include <span>

#include "engine/gpu/shader_library.hpp"

namespace windloom {

/// Every variant, for the test that compiles all. Those of the tail have example sizes.
std::span<const gpu::ProgramSpec> windPrograms();

/// The variant with this name; asking for another one is a broken promise.
const gpu::ProgramSpec& windProgram(std::string_view name);

/// The variant of a pressure pass that coarsens by these factors: name "wind/pressure PASS 4x2".
const gpu::ProgramSpec& pressureProgram(std::string_view pass, glm::ivec2 factor);

}  // namespace windloom
