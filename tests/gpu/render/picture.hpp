#pragma once
// Small pictures for tests: drawn offscreen, read back, measured.

#include <gtest/gtest.h>

#include <vector>

#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/render/frame_renderer.hpp"
#include "engine/render/framing.hpp"

namespace windloom::testing {

struct Picture {
  glm::ivec2 size{0};
  std::vector<unsigned char> rgba;  // top row first

  [[nodiscard]] glm::vec3 at(int x, int y) const {
    const std::size_t i = (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)) * 4;
    return glm::vec3(rgba[i], rgba[i + 1], rgba[i + 2]);
  }
  [[nodiscard]] float light(int x, int y) const { return glm::dot(at(x, y), glm::vec3(0.3f, 0.6f, 0.1f)); }
  /// Mean colour of a rectangle, 0..255.
  [[nodiscard]] glm::vec3 mean(glm::ivec2 low, glm::ivec2 high) const {
    glm::vec3 sum(0.0f);
    for (int y = low.y; y < high.y; ++y) {
      for (int x = low.x; x < high.x; ++x) sum += at(x, y);
    }
    return sum / static_cast<float>((high.x - low.x) * (high.y - low.y));
  }
};

/// Mean absolute difference per channel, 0..255.
inline float difference(const Picture& a, const Picture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i]));
  return static_cast<float>(sum / static_cast<double>(a.rgba.size()));
}

/// A texture of the same wind everywhere.
inline gpu::Texture uniformWind(glm::vec2 wind, int cells = 16) {
  auto texture = gpu::Texture::create2D("test wind", {cells, cells}, GL_RG32F, {.filter = gpu::Filter::Nearest});
  const std::vector<glm::vec2> values(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells), wind);
  texture->upload(GL_RG, GL_FLOAT, values.data());
  return std::move(*texture);
}

/// Looks straight down at a square of `metres` around a place.
inline ViewCamera above(glm::vec2 centre, float metres) {
  ViewCamera camera = frameFieldFromAbove({});
  camera.position = {centre.x, 60.0f, centre.y};
  camera.target = {centre.x, 0.0f, centre.y};
  camera.orthographicHeight = metres;
  return camera;
}

inline Picture draw(FrameRenderer& renderer, FrameInput input) {
  auto target = gpu::Framebuffer::create("test picture", input.size, {.colour = GL_RGBA8, .depth = 0});
  EXPECT_TRUE(target.ok());
  target->clearColour({1.0f, 0.0f, 1.0f, 0.0f});
  input.framebuffer = target->name();
  renderer.render(input);
  return {input.size, target->readRgba8()};
}

}  // namespace windloom::testing
