#include "engine/cli/bench_views.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windloom::cli {

BenchMeadow benchMeadowOf(int millions) {
  const float metres = millions <= 7 ? 100.0f : 1000.0f;
  return {std::to_string(millions) + " M", metres, static_cast<float>(millions) * 1e6f / (metres * metres)};
}

std::vector<BenchShot> benchShots(float metres) {
  BenchShot eye{"eye", {}}, over{"over", {}}, top{"top", {}};
  eye.camera.position = {0, 1.7f, 0.4f * metres};
  eye.camera.target = {0, 1.2f, 0};
  over.camera.position = {0, 0.25f * metres, 0.65f * metres};
  top.camera.position = {0, 1.3f * metres, 0};
  top.camera.up = {0, 0, -1};
  for (BenchShot* shot : {&eye, &over, &top}) shot->camera.farPlane = std::max(2000.0f, 4.0f * metres);
  return {eye, over, top};
}

Result<gpu::Texture> benchWhirls(const GridMapping& grid) {
  Result<gpu::Texture> texture = gpu::Texture::create2D("bench wind", grid.resolution, GL_RG32F);
  if (!texture) return texture;
  std::vector<glm::vec2> cells;
  const float wave = 2.0f * std::numbers::pi_v<float> / 25.0f;
  for (int k = 0; k < grid.resolution.y; ++k) {
    for (int i = 0; i < grid.resolution.x; ++i) {
      const glm::vec2 at = cellCentreToWorld(glm::vec2(i, k), grid.minCorner, grid.cellSize) * wave;
      cells.push_back(8.0f * glm::vec2(std::sin(at.x) * std::cos(at.y), -std::cos(at.x) * std::sin(at.y)));
    }
  }
  texture->upload(GL_RG, GL_FLOAT, cells.data());
  return texture;
}

Result<gpu::Framebuffer> benchTarget(glm::ivec2 size) {
  return gpu::Framebuffer::create("bench picture", size, {.colour = GL_RGBA8, .depth = 0});
}

Image rgbOf(const gpu::Framebuffer& target) {
  const std::vector<unsigned char> rgba = target.readRgba8();
  Image image(target.size().x, target.size().y, 3);
  for (std::size_t i = 0; i * 4 < rgba.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) image.pixels[i * 3 + c] = rgba[i * 4 + c];
  }
  return image;
}

FloatImage halfLuma(const gpu::Framebuffer& target) {
  return lumaOf(boxFiltered(rgbOf(target), 2));
}

FrameInput benchFrame(const Project& project, const WindTexture& wind, const ViewCamera& camera,
                      const gpu::Framebuffer& target) {
  FrameInput input;
  input.project = &project;
  input.wind = wind;
  input.camera = camera;
  input.size = target.size();
  input.framebuffer = target.name();
  input.overlays.arrows = false;
  return input;
}

}  // namespace windloom::cli
