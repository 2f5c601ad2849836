#include "editor/app/frame_picture.hpp"

#include <epoxy/gl.h>

#include <cstring>

#include "engine/io/image.hpp"

namespace windloom::editor {

Status saveFramePicture(const std::filesystem::path& path, glm::ivec2 framebufferSize) {
  Image bottomUp(framebufferSize.x, framebufferSize.y, 3);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, framebufferSize.x, framebufferSize.y, GL_RGB, GL_UNSIGNED_BYTE, bottomUp.pixels.data());
  Image picture(framebufferSize.x, framebufferSize.y, 3);
  for (int y = 0; y < picture.height; ++y)
    std::memcpy(picture.at(0, y), bottomUp.at(0, picture.height - 1 - y), std::size_t(picture.width) * 3);
  return writePng(path, picture);
}

}  // namespace windloom::editor
