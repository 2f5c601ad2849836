#pragma once
// The window's picture as a file, for docs and tests (`--screenshot`).

#include <filesystem>
#include <glm/glm.hpp>

#include "engine/core/result.hpp"

namespace windloom::editor {

/// Writes what is in the window's back buffer as an 8-bit PNG. Fails with Machine.
Status saveFramePicture(const std::filesystem::path& path, glm::ivec2 framebufferSize);

}  // namespace windloom::editor
