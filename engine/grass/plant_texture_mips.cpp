#include "engine/grass/plant_texture_mips.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace windloom {
namespace {

float toLinear(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}
float toEncoded(float linear) {
  return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}
std::uint8_t toByte(float value) {
  return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
}

/// A level as linear light with alpha.
struct Light {
  glm::ivec2 size{0};
  std::vector<glm::vec4> pixels;
  [[nodiscard]] const glm::vec4& at(int x, int y) const {
    const int u = std::min(x, size.x - 1), v = std::min(y, size.y - 1);
    return pixels[static_cast<std::size_t>(v) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(u)];
  }
};

Light halved(const Light& from) {
  Light to;
  to.size = glm::max(from.size / 2, glm::ivec2(1));
  to.pixels.reserve(static_cast<std::size_t>(to.size.x) * static_cast<std::size_t>(to.size.y));
  for (int y = 0; y < to.size.y; ++y) {
    for (int x = 0; x < to.size.x; ++x) {
      glm::vec3 weighted(0.0f), plain(0.0f);
      float alpha = 0.0f;
      for (const glm::ivec2 part : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)}) {
        const glm::vec4& p = from.at(2 * x + part.x, 2 * y + part.y);
        weighted += glm::vec3(p) * p.a;
        plain += glm::vec3(p);
        alpha += p.a;
      }
      to.pixels.emplace_back(alpha > 1e-4f ? weighted / alpha : 0.25f * plain, 0.25f * alpha);
    }
  }
  return to;
}

MipLevel encoded(const Light& light, float alphaScale) {
  MipLevel level{light.size, {}};
  level.pixels.reserve(light.pixels.size() * 4);
  for (const glm::vec4& p : light.pixels) {
    for (int c = 0; c < 3; ++c) level.pixels.push_back(toByte(toEncoded(p[c])));
    level.pixels.push_back(toByte(p.a * alphaScale));
  }
  return level;
}

/// The factor of alpha that leaves `wanted` of the pixels above the cutoff.
float scaleFor(const Light& light, float cutoff, float wanted) {
  std::vector<float> alphas;
  alphas.reserve(light.pixels.size());
  for (const glm::vec4& p : light.pixels) alphas.push_back(p.a);
  const auto above = static_cast<std::size_t>(std::lround(wanted * static_cast<float>(alphas.size())));
  if (above == 0) return 1.0f;
  std::ranges::sort(alphas, std::greater<>());
  // Many pixels may have the same alpha: with all of them or without, whichever comes nearer.
  const auto [first, last] = std::ranges::equal_range(alphas, alphas[above - 1], std::greater<>());
  const auto with = static_cast<std::size_t>(last - alphas.begin()),
             without = static_cast<std::size_t>(first - alphas.begin());
  const bool all = without == 0 || with - above <= above - without;
  const float least = all ? alphas[above - 1] : alphas[without - 1];
  return least > 1e-3f ? std::clamp(cutoff / least, 0.25f, 8.0f) : 1.0f;
}

}  // namespace

float alphaCoverage(const MipLevel& level, float cutoff) {
  std::size_t above = 0;
  const std::size_t count = level.pixels.size() / 4;
  for (std::size_t i = 0; i < count; ++i) {
    if (static_cast<float>(level.pixels[4 * i + 3]) >= 255.0f * cutoff) ++above;
  }
  return count == 0 ? 0.0f : static_cast<float>(above) / static_cast<float>(count);
}

std::vector<MipLevel> mipLevels(const PlantMesh& mesh) {
  std::vector<MipLevel> levels;
  if (mesh.textureSize.x <= 0 || mesh.textureSize.y <= 0) return levels;
  levels.push_back({mesh.textureSize, mesh.texture});
  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = toLinear(static_cast<float>(i) / 255.0f);
  Light light{mesh.textureSize, {}};
  for (std::size_t i = 0; i + 3 < mesh.texture.size(); i += 4) {
    light.pixels.emplace_back(linear[mesh.texture[i]], linear[mesh.texture[i + 1]], linear[mesh.texture[i + 2]],
                              static_cast<float>(mesh.texture[i + 3]) / 255.0f);
  }
  const float wanted = alphaCoverage(levels.front(), mesh.alphaCutoff);
  while (std::max(light.size.x, light.size.y) > 1) {
    light = halved(light);
    levels.push_back(encoded(light, scaleFor(light, mesh.alphaCutoff, wanted)));
  }
  return levels;
}

}  // namespace windloom
