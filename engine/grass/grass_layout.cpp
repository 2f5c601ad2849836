#include "engine/grass/grass_layout.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

// Tiles of about this many blades keep both the number of tiles and the blades placed in vain low; 256 and
// 4096 were slower on llvmpipe at 1280 x 720.
constexpr float kBladesPerTile = 1024.0f;
constexpr float kMinTileM = 1.0f, kMaxTileM = 8.0f;
constexpr int kMaxTilesPerSide = 1024;

// Blades narrower than this on screen are thinned and widened instead, at full detail. With four samples a
// pixel one pixel neither shimmers nor shows its widening.
constexpr float kLeastPixels = 1.0f;
constexpr float kMostWidening = 5.0f;
// Blades lower than this many pixels are left to the ground's shading.
constexpr float kFadePixels = 2.2f;

// Most blades in the lists of each level, whatever the project: 157 MB of records.
constexpr std::uint32_t kLevelLimits[3] = {400'000, 1'500'000, 3'000'000};

float smoothStep(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

}  // namespace

GrassLayout makeGrassLayout(const FieldSettings& field, const GrassSettings& grass) {
  GrassLayout layout;
  const double area = static_cast<double>(field.size.x) * static_cast<double>(field.size.y);
  const float density = shownDensity(grass);
  layout.bladesTotal = std::llround(static_cast<double>(density) * area);
  if (density <= 0.0f) return layout;
  const glm::vec2 covered = field.size + 2.0f * kMeadowMarginM;
  const float wanted = std::clamp(std::sqrt(kBladesPerTile / density), kMinTileM, kMaxTileM);
  layout.tileSideM = std::max(wanted, std::max(covered.x, covered.y) / static_cast<float>(kMaxTilesPerSide));
  layout.tiles = glm::max(glm::ivec2(glm::ceil(covered / layout.tileSideM)), glm::ivec2(1));
  layout.origin = field.centre - 0.5f * layout.tileSideM * glm::vec2(layout.tiles);
  layout.bladesInTile = density * layout.tileSideM * layout.tileSideM;
  const auto tileCount = static_cast<std::uint32_t>(layout.tiles.x) * static_cast<std::uint32_t>(layout.tiles.y);
  const auto mostInTile = static_cast<std::uint32_t>(std::floor(layout.bladesInTile)) + 1u;
  layout.chunkLimit = tileCount * ((mostInTile + GRASS_CHUNK - 1u) / GRASS_CHUNK);
  const double most = static_cast<double>(tileCount) * static_cast<double>(mostInTile);
  for (int level = 0; level < 3; ++level) {
    layout.capacity[level] = static_cast<std::uint32_t>(std::min(most, static_cast<double>(kLevelLimits[level])));
  }
  return layout;
}

std::vector<glm::vec2> groundInTiles(const GrassLayout& layout, const HeightField& ground) {
  std::vector<glm::vec2> bounds;
  bounds.reserve(static_cast<std::size_t>(layout.tiles.x) * static_cast<std::size_t>(layout.tiles.y));
  for (int z = 0; z < layout.tiles.y; ++z) {
    for (int x = 0; x < layout.tiles.x; ++x) {
      const glm::vec2 low = layout.origin + layout.tileSideM * glm::vec2(x, z);
      const HeightRange range = heightsOver(ground, low, low + layout.tileSideM);
      bounds.emplace_back(range.lowest, range.highest);
    }
  }
  return bounds;
}

GrassBlock makeGrassBlock(const GrassSettings& grass, const GrassLayout& layout, float detail) {
  const float quality = std::clamp(detail, 0.02f, 1.0f);
  const float tallest = std::max(grass.height * (1.0f + grass.heightVariation), 0.01f);
  const float arc = grass.deformation == Deformation::Arc ? GRASS_DEFORMATION_ARC : GRASS_DEFORMATION_QUADRATIC;
  const float density = shownDensity(grass);
  // Part of the ground that upright blades hide from a ray at 45 degrees.
  const float closed = 1.0f - std::exp(-1.3f * density * grass.width * grass.height);
  GrassBlock block{};
  block.baseColour = {grass.baseColour, grass.height};
  block.tipColour = {grass.tipColour, grass.heightVariation};
  block.dryColour = {grass.dryColour, grass.dryness};
  block.size = {grass.width, tallest, grass.clumping, arc};
  block.motion = {grass.windFactor / std::max(grass.stiffness, 1e-3f), grass.stiffnessVariation, grass.flutter,
                  grass.restBlend};
  block.droop = {grass.droopDown, grass.droopForward, density, static_cast<float>(grass.seed & 0xffffff)};
  block.shadow = {grass.shadowMin, grass.shadowMax, grass.shadowWind, grass.shadowOffset};
  block.tiles = {static_cast<float>(layout.tiles.x), static_cast<float>(layout.tiles.y), layout.tileSideM,
                 layout.bladesInTile};
  block.tileOrigin = {layout.origin, kMeadowMarginM, 0.0f};
  block.cover = {kLeastPixels / quality, kMostWidening, quality, kFadePixels / std::sqrt(quality)};
  const float coarser = 1.0f / std::sqrt(quality);
  block.levels = {70.0f * coarser, 20.0f * coarser, closed, density * grass.width * grass.height};
  block.capacity = {glm::vec3(layout.capacity), 0.0f};
  return block;
}

float keptPart(const GrassBlock& block, float pixelsPerMetre) {
  const float byWidth = block.size.x * pixelsPerMetre / block.cover.x;
  const float byHeight = smoothStep(0.6f, 1.6f, block.baseColour.w * pixelsPerMetre / block.cover.w);
  return std::min(byWidth * byHeight, 1.0f);
}

}  // namespace windloom
