#pragma once

#include <string>

namespace game {

/// Writes what was just drawn into the current framebuffer as PNG; false where the file can't be written.
bool saveScreenshot(const std::string& path, int width, int height);

}  // namespace game
