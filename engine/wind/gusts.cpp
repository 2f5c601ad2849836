// Perlin, Improving Noise, 2002 (gradient noise with a quintic fade) as the stream function of a field without
// divergence, so that the projection takes nothing of it away (Bridson, Hourihan & Nordenstam, Curl-noise, 2007).
#include "engine/wind/gusts.hpp"

#include <cmath>
#include <numbers>

#include "engine/core/hash.hpp"

namespace windloom {
namespace {

constexpr int kSide = WIND_GUST_TABLE;
constexpr int kLattice = 16;                    // gradients per side
constexpr int kTexels = kSide / kLattice;       // texels from gradient to gradient
constexpr double kTexelsPerWave = 2 * kTexels;  // the noise's strongest wavelength is about two lattice cells

struct LayerShape {
  double size, speed, turn, weight;  // factors on gustSize and gustSpeed, angle to the wind (rad), share
};
// Three sizes without a common multiple, slightly turned: the sum shows no repeat.
constexpr LayerShape kShapes[WIND_GUST_LAYERS] = {
    {1.0, 1.0, 0.0, 0.5}, {0.46, 1.3, 0.61, 0.35}, {2.1, 0.8, -0.87, 0.35}};

std::size_t texel(int i, int k) {
  return static_cast<std::size_t>((k + kSide) % kSide) * kSide + static_cast<std::size_t>((i + kSide) % kSide);
}

double fade(double t) {
  return t * t * t * (t * (t * 6 - 15) + 10);
}

double gradientTerm(std::uint32_t seed, int gi, int gk, double dx, double dz) {
  const std::uint32_t place = static_cast<std::uint32_t>((gk % kLattice) * kLattice + gi % kLattice);
  const double angle = 2 * std::numbers::pi * static_cast<double>(hashToUnit(hashCombine(seed, place)));
  return std::cos(angle) * dx + std::sin(angle) * dz;
}

double noiseAt(std::uint32_t seed, int i, int k) {
  const int gi = i / kTexels, gk = k / kTexels;
  const double x = double(i % kTexels) / kTexels, z = double(k % kTexels) / kTexels;
  const double low = std::lerp(gradientTerm(seed, gi, gk, x, z), gradientTerm(seed, gi + 1, gk, x - 1, z), fade(x));
  const double high =
      std::lerp(gradientTerm(seed, gi, gk + 1, x, z - 1), gradientTerm(seed, gi + 1, gk + 1, x - 1, z - 1), fade(x));
  return std::lerp(low, high, fade(z));
}

double wrapTexels(double value) {
  return value - kSide * std::floor(value / kSide);
}

glm::vec2 sampleTable(const std::vector<glm::vec2>& table, glm::vec2 place) {
  const glm::vec2 low = glm::floor(place);
  const glm::vec2 t = place - low;
  const auto wrap = [](float value) {
    return static_cast<int>(value - float(kSide) * std::floor(value / float(kSide)));
  };
  const int i = wrap(low.x), k = wrap(low.y);
  const glm::vec2 a = table[texel(i, k)], b = table[texel(i + 1, k)], c = table[texel(i, k + 1)],
                  d = table[texel(i + 1, k + 1)];
  const glm::vec2 ab = a + (b - a) * t.x;
  const glm::vec2 cd = c + (d - c) * t.x;
  return ab + (cd - ab) * t.y;
}

}  // namespace

std::vector<glm::vec2> makeGustTable(int seed) {
  const std::uint32_t hashed = pcgHash(static_cast<std::uint32_t>(seed) + 0x67757374u);
  std::vector<double> stream(std::size_t{kSide} * kSide);
  for (int k = 0; k < kSide; ++k) {
    for (int i = 0; i < kSide; ++i) stream[texel(i, k)] = noiseAt(hashed, i, k);
  }
  std::vector<glm::dvec2> curl(stream.size());
  double square = 0;
  for (int k = 0; k < kSide; ++k) {
    for (int i = 0; i < kSide; ++i) {
      glm::dvec2& v = curl[texel(i, k)];
      v = {stream[texel(i, k - 1)] - stream[texel(i, k + 1)], stream[texel(i + 1, k)] - stream[texel(i - 1, k)]};
      square += v.x * v.x + v.y * v.y;
    }
  }
  const double scale = square > 0 ? 1 / std::sqrt(square / static_cast<double>(curl.size())) : 0;
  std::vector<glm::vec2> table(curl.size());
  for (std::size_t n = 0; n < curl.size(); ++n) table[n] = glm::vec2(curl[n] * scale);
  return table;
}

std::array<WindGustLayer, WIND_GUST_LAYERS> gustLayersAt(const AmbientWind& ambient, double time) {
  std::array<WindGustLayer, WIND_GUST_LAYERS> layers{};
  const double heading = glm::radians(static_cast<double>(ambient.direction));
  for (std::size_t n = 0; n < layers.size(); ++n) {
    const LayerShape& shape = kShapes[n];
    const double angle = heading + shape.turn;
    const double texelsPerMetre = kTexelsPerWave / (static_cast<double>(ambient.gustSize) * shape.size);
    const double travelled = static_cast<double>(ambient.gustSpeed) * shape.speed * time * texelsPerMetre;
    layers[n].axis = glm::vec2(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
    layers[n].offset = glm::vec2(static_cast<float>(wrapTexels(-travelled * std::cos(shape.turn))),
                                 static_cast<float>(wrapTexels(travelled * std::sin(shape.turn))));
    layers[n].texelsPerMetre = static_cast<float>(texelsPerMetre);
    layers[n].weight = static_cast<float>(shape.weight);
  }
  return layers;
}

glm::vec2 gustAt(const std::vector<glm::vec2>& table, const std::array<WindGustLayer, WIND_GUST_LAYERS>& layers,
                 glm::vec2 world) {
  glm::vec2 sum(0);
  for (const WindGustLayer& layer : layers) {
    const glm::vec2 across(-layer.axis.y, layer.axis.x);
    const glm::vec2 place =
        glm::vec2(glm::dot(world, layer.axis), glm::dot(world, across)) * layer.texelsPerMetre + layer.offset;
    const glm::vec2 sample = sampleTable(table, place);
    sum += layer.weight * (sample.x * layer.axis + sample.y * across);
  }
  return sum;
}

float gustAmplitude(const AmbientWind& ambient) {
  return ambient.gustStrength * ambient.speed;
}

}  // namespace windloom
