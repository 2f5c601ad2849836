// What shaders/include/grass_blades.glsl and shaders/grass/place_blades.comp make of the same settings for the
// instanced grass, but in a tile that wraps around, and without the meadow's broad patches: those are the renderer's.
#include "engine/grass/shell_blades.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/grass/growth_area.hpp"
#include "engine/grass/shell_clumps.hpp"
#include "engine/grass/shell_colour.hpp"
#include "shaders/shared/grass_block.h"

namespace windloom {
namespace {

constexpr float kTurn = 6.2831853f;
constexpr float kClumpEdges = 0.5f;  // clumps: how far blades of neighbouring ones stand among each other
constexpr double kMostBlades = 400'000;
constexpr double kMostLayers = 24;  // more of them on one another show no more
constexpr float kThinnestTexels = 1.2f;

/// A species of blades.
struct Kind {
  glm::vec3 baseColour, tipColour;
  float height, heightVariation;
  glm::vec2 radii;  ///< m, of a cut of the mean width
  double weight;    ///< blades for each of the meadow's own
  double kept;      ///< part of them that are left where the texture is too coarse for them
};

struct Kinds {
  std::vector<Kind> list;
  double all = 0;  ///< weights of all plants, those of other shapes and hidden ones, too
};

float luma(glm::vec3 colour) {
  return glm::dot(colour, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

double areaOf(glm::vec2 radii) {
  return std::numbers::pi * static_cast<double>(radii.x) * static_cast<double>(radii.y);
}

/// A cut of this width that the texture can hold: as large as wanted where possible.
glm::vec2 cutRadii(float width, float thickness, float texelM) {
  const float least = 0.5f * kThinnestTexels * texelM;
  const glm::vec2 wanted(0.5f * width, 0.5f * width * thickness);
  const float across = std::max(wanted.y, least);
  return {std::max(wanted.x * wanted.y / across, across), across};
}

Kind makeKind(const Species& species, float thickness, float texelM) {
  Kind kind{species.baseColour, species.tipColour, species.height, species.heightVariation, {}, 0.0, 1.0};
  kind.radii = cutRadii(species.width, thickness, texelM);
  kind.weight = static_cast<double>(std::max(species.weight, 0.0f));
  kind.kept = std::min(areaOf(glm::vec2(0.5f, 0.5f * thickness) * species.width) / areaOf(kind.radii), 1.0);
  return kind;
}

/// The meadow's own blades first, then the species that are blades, as many as the instanced grass shows.
Kinds kindsOf(const GrassSettings& grass, const ShellSettings& shell, std::span<const Species> species, float texelM) {
  const float thickness = std::clamp(shell.thickness, 0.05f, 1.0f);
  Species own;
  own.weight = 1.0f;
  own.height = grass.height;
  own.heightVariation = grass.heightVariation;
  own.width = grass.width;
  own.baseColour = grass.baseColour;
  own.tipColour = grass.tipColour;
  Kinds kinds;
  kinds.list.push_back(makeKind(own, thickness, texelM));
  kinds.all = 1.0;
  for (const Species& other : species) {
    kinds.all += static_cast<double>(std::max(other.weight, 0.0f));
    if (other.shape != PlantShape::Blade || other.hidden || other.weight <= 0.0f) continue;
    if (kinds.list.size() < GRASS_SPECIES) kinds.list.push_back(makeKind(other, thickness, texelM));
  }
  return kinds;
}

struct Count {
  std::size_t blades = 1;
  float widening = 1;
};

Count countOf(const GrassSettings& grass, const ShellSettings& shell, const Kinds& kinds) {
  const auto side = static_cast<double>(shell.tile);
  const double wanted = static_cast<double>(shell.fullness) * static_cast<double>(grass.density) * side * side;
  double blades = 0, covered = 0;
  for (const Kind& kind : kinds.list) {
    const double count = wanted * kind.weight * kind.kept / kinds.all;
    blades += count;
    covered += count * areaOf(kind.radii);
  }
  const double layers = covered / (side * side);
  if (layers > kMostLayers) blades *= kMostLayers / layers;
  Count count;
  count.widening = static_cast<float>(std::sqrt(std::max(blades / kMostBlades, 1.0)));
  count.blades = static_cast<std::size_t>(std::max(std::round(std::min(blades, kMostBlades)), 1.0));
  return count;
}

std::uint32_t reversed(std::uint32_t bits) {
  bits = bits >> 16 | bits << 16;
  bits = (bits >> 8 & 0x00ff00ffu) | (bits & 0x00ff00ffu) << 8;
  bits = (bits >> 4 & 0x0f0f0f0fu) | (bits & 0x0f0f0f0fu) << 4;
  bits = (bits >> 2 & 0x33333333u) | (bits & 0x33333333u) << 2;
  return (bits >> 1 & 0x55555555u) | (bits & 0x55555555u) << 1;
}

/// Owen's scrambling, as in the shader.
std::uint32_t scrambled(std::uint32_t bits, std::uint32_t seed) {
  bits = reversed(bits);
  bits ^= bits * 0x3d20adeau;
  bits += seed;
  bits *= (seed >> 16) | 1u;
  bits ^= bits * 0x05526c56u;
  bits ^= bits * 0x53a22864u;
  return reversed(bits);
}

std::uint32_t sobolSecond(std::uint32_t index) {
  std::uint32_t bits = 0;
  for (std::uint32_t v = 0x80000000u; index != 0; index >>= 1, v ^= v >> 1) {
    if ((index & 1u) != 0) bits ^= v;
  }
  return bits;
}

/// 0..1: any first part of the blades covers the tile evenly, so that thinning leaves no holes.
glm::vec2 placeOf(std::uint32_t index, std::uint32_t seed) {
  return {hashToUnit(scrambled(reversed(index), pcgHash(seed))),
          hashToUnit(scrambled(sobolSecond(index), pcgHash(seed ^ 0x9e3779b9u)))};
}

const Kind& kindAt(const Kinds& kinds, double pick) {
  double total = 0;
  for (const Kind& kind : kinds.list) total += kind.weight * kind.kept;
  double left = pick * total;
  for (const Kind& kind : kinds.list) {
    left -= kind.weight * kind.kept;
    if (left < 0) return kind;
  }
  return kinds.list.front();
}

glm::vec3 upperColour(const GrassSettings& grass, const Kind& kind, RandomStream& random, const ShellClump& clump) {
  const float alike = grass.clumping;
  const bool isDry = glm::mix(random.next(), clump.dry, 0.6f * alike + 0.2f) >= 1.0f - grass.dryness;
  const float dry = isDry ? 0.45f + 0.5f * random.next() : 0.0f;
  const float bright = 0.78f + 0.44f * glm::mix(random.next(), clump.bright, 0.5f * alike);
  const float hue = 2.0f * glm::mix(random.next(), clump.hue, 0.7f * alike) - 1.0f;
  const glm::vec3 colour = glm::mix(kind.tipColour, grass.dryColour, dry);
  return colour * bright * (1.0f + hue * glm::vec3(0.16f, 0.03f, -0.14f));
}

/// What all blades share.
struct Tile {
  float side;
  std::uint32_t seed;
  ShellClumps clumps;
};

ShellBlade makeBlade(const GrassSettings& grass, const Kinds& kinds, const Tile& tile, const Count& count,
                     std::uint32_t index) {
  RandomStream random(hashCombine(tile.seed ^ 0x2545f491u, index));
  const glm::vec2 place = placeOf(index, tile.seed);
  const float aside = random.next() - 0.5f, beyond = random.next() - 0.5f;
  const ShellClump& clump =
      tile.clumps.at(place + glm::vec2(aside, beyond) * (kClumpEdges / static_cast<float>(tile.clumps.cells())));
  const Kind& kind = kindAt(kinds, static_cast<double>(random.next()));
  ShellBlade blade;
  blade.root = place * tile.side;
  const float first = random.next(), second = random.next();
  const float own = std::clamp(0.5f + 1.15f * (glm::mix(first, second, 0.55f) - 0.5f), 0.0f, 1.0f);
  const float size = glm::mix(own, clump.size, 0.5f * grass.clumping);
  blade.height = std::max(kind.height * (1.0f + kind.heightVariation * (2.0f * size - 1.0f)), 1e-4f);
  // Most blades of a clump face the same way; the long axis lies across.
  const float yaw = kTurn * random.next(), lean = kTurn * clump.lean;
  const glm::vec2 front = glm::vec2(std::cos(yaw), std::sin(yaw)) +
                          0.8f * grass.clumping * glm::vec2(std::cos(lean), std::sin(lean)) + glm::vec2(1e-4f);
  blade.along = glm::normalize(glm::vec2(-front.y, front.x));
  blade.radii = kind.radii * (count.widening * (0.8f + 0.4f * random.next()));
  blade.rank = static_cast<std::uint8_t>(255ull * index / count.blades);
  blade.own = static_cast<std::uint8_t>(256.0f * random.next());
  blade.rootLight = std::clamp(luma(kind.baseColour) / std::max(luma(kind.tipColour), 1e-4f), 0.0f, 1.0f);
  blade.colour = upperColour(grass, kind, random, clump);
  return blade;
}

}  // namespace

ShellBlades growShellBlades(const GrassSettings& grass, const ShellSettings& shell, std::span<const Species> species,
                            float texelM) {
  const Kinds kinds = kindsOf(grass, shell, species, texelM);
  const Count count = countOf(grass, shell, kinds);
  const std::uint32_t seed = pcgHash(static_cast<std::uint32_t>(grass.seed) ^ 0x51ed270bu);
  const Tile tile{shell.tile, seed, ShellClumps(shell.tile, seed ^ 0x3c6ef372u)};
  ShellBlades grown;
  for (const Kind& kind : kinds.list) {
    grown.tallestM = std::max({grown.tallestM, kind.height * (1.0f + kind.heightVariation), 1e-3f});
  }
  grown.blades.reserve(count.blades);
  for (std::size_t i = 0; i < count.blades; ++i) {
    grown.blades.push_back(makeBlade(grass, kinds, tile, count, static_cast<std::uint32_t>(i)));
  }
  return grown;
}

}  // namespace windloom
