// Gradient noise after Perlin, "Improving Noise", 2002, on a lattice that repeats.
#include "engine/render/noise_texture.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/hash.hpp"

namespace windloom {
namespace {

float fade(float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }

float gradient(int x, int y, glm::ivec2 period, std::uint32_t seed, glm::vec2 offset) {
  const auto px = static_cast<std::uint32_t>((x % period.x + period.x) % period.x);
  const auto py = static_cast<std::uint32_t>((y % period.y + period.y) % period.y);
  const float turn = 6.2831853f * hashToUnit(hashCombine(hashCombine(px, py), seed));
  return std::cos(turn) * offset.x + std::sin(turn) * offset.y;
}

float perlin(glm::vec2 at, glm::ivec2 period, std::uint32_t seed) {
  const glm::vec2 cell = glm::floor(at);
  const glm::vec2 f = at - cell;
  const int x = static_cast<int>(cell.x), y = static_cast<int>(cell.y);
  const auto corner = [&](int dx, int dy) { return gradient(x + dx, y + dy, period, seed, f - glm::vec2(dx, dy)); };
  const float u = fade(f.x), v = fade(f.y);
  return glm::mix(glm::mix(corner(0, 0), corner(1, 0), u), glm::mix(corner(0, 1), corner(1, 1), u), v);
}

float fractal(glm::vec2 uv, glm::ivec2 period, int octaves, std::uint32_t seed) {
  float sum = 0.0f, amplitude = 1.0f;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * perlin(uv * glm::vec2(period), period, seed + static_cast<std::uint32_t>(octave));
    amplitude *= 0.5f;
    period *= 2;
  }
  return sum;
}

float streaks(glm::vec2 uv) {
  const float warp = fractal(uv, {5, 5}, 2, 90);
  return fractal(uv + glm::vec2(0.02f, 0.0f) * warp, {48, 9}, 2, 70) + 0.6f * fractal(uv, {11, 40}, 2, 80);
}

/// Spreads a channel so that its mean lies at 0.5 and 2.2 deviations reach the ends.
void normalise(const std::vector<float>& values, std::vector<std::uint8_t>& texels, std::size_t channel) {
  double sum = 0.0, squares = 0.0;
  for (const float value : values) {
    sum += static_cast<double>(value);
    squares += static_cast<double>(value) * static_cast<double>(value);
  }
  const double count = static_cast<double>(values.size());
  const double mean = sum / count;
  const double deviation = std::sqrt(std::max(squares / count - mean * mean, 1e-12));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double level = 0.5 + (static_cast<double>(values[i]) - mean) / (4.4 * deviation);
    texels[i * 4 + channel] = static_cast<std::uint8_t>(std::lround(std::clamp(level, 0.0, 1.0) * 255.0));
  }
}

}  // namespace

std::vector<std::uint8_t> makeNoise() {
  constexpr std::size_t kCount = static_cast<std::size_t>(kNoiseSide) * kNoiseSide;
  std::vector<std::uint8_t> texels(kCount * 4);
  std::vector<float> values(kCount);
  for (std::size_t channel = 0; channel < 4; ++channel) {
    for (std::size_t i = 0; i < kCount; ++i) {
      const glm::vec2 uv = glm::vec2(static_cast<float>(i % kNoiseSide), static_cast<float>(i / kNoiseSide)) / float(kNoiseSide);
      switch (channel) {
        case 0: values[i] = fractal(uv, {5, 5}, 4, 10); break;
        case 1: values[i] = fractal(uv, {7, 7}, 4, 30); break;
        case 2: values[i] = fractal(uv, {32, 32}, 2, 50); break;
        default: values[i] = streaks(uv); break;
      }
    }
    normalise(values, texels, channel);
  }
  return texels;
}

Result<gpu::Texture> createNoiseTexture() {
  const std::vector<std::uint8_t> texels = makeNoise();
  Result<gpu::Texture> texture = gpu::Texture::create2D(
      "noise", {kNoiseSide, kNoiseSide}, GL_RGBA8, {.levels = 0, .filter = gpu::Filter::Trilinear, .wrap = gpu::Wrap::Repeat});
  if (!texture) return texture;
  texture->upload(GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  texture->generateMipmaps();
  return texture;
}

}  // namespace windloom
