#include "engine/grass/grass_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/hash.hpp"
#include "shaders/shared/grass_density.h"

namespace windloom {
namespace {

// Tiles of about this many blades keep both the number of tiles and the blades placed in vain low; 256 and
// 4096 were slower on llvmpipe at 1280 x 720.
constexpr float kBladesPerTile = 1024.0f;
constexpr float kMinTileM = 1.0f, kMaxTileM = 8.0f;

// Blades narrower than this on screen are thinned and widened instead, at full detail. With four samples a
// pixel such blades neither shimmer nor show their widening.
constexpr float kLeastPixels = 1.35f;
constexpr float kMostWidening = 5.0f;
// A low quality doesn't broaden blades beyond this.
constexpr float kBroadestPixels = 5.2f;
// Blades lower than this many pixels are left to the ground's shading.
constexpr float kFadePixels = 2.2f;
// Layers of blades along a ray beyond which more of them aren't seen.
constexpr float kLayers = 6.0f;
constexpr float kContourLift = 0.05f;  // as in grass_tiles.glsl

float cosineOf(float degrees) {
  return std::cos(glm::radians(std::clamp(degrees, 0.0f, 90.0f)));
}

/// m from the camera at which blades have faded into the ground.
float reachOf(const GrassBlock& block, const shared::FrameBlock& frame) {
  const float pixels = 0.6f * block.cover.w / block.baseColour.w;
  return frame.pixelScale.x / pixels;
}

struct Area {
  glm::vec2 low, high;  // m
};

/// Part of the ground that the camera may see blades on.
Area seenArea(const GrassBlock& block, const shared::FrameBlock& frame) {
  const glm::vec2 eye(frame.cameraPosition.x, frame.cameraPosition.z);
  if (frame.cameraPosition.w < 0.5f) {
    const float reach = block.tileCentre.w > 0.5f ? 1e7f : reachOf(block, frame);
    return {eye - reach, eye + reach};
  }
  // Parallel rays: what the corners of the picture see between the near and the far plane.
  Area area{glm::vec2(std::numeric_limits<float>::max()), glm::vec2(std::numeric_limits<float>::lowest())};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec4 clip((corner & 1) != 0 ? 1.0f : -1.0f, (corner & 2) != 0 ? 1.0f : -1.0f,
                         (corner & 4) != 0 ? 1.0f : -1.0f, 1.0f);
    const glm::vec4 world = frame.inverseViewProjection * clip;
    const glm::vec2 at = glm::vec2(world.x, world.z) / world.w;
    area.low = glm::min(area.low, at);
    area.high = glm::max(area.high, at);
  }
  const bool tooSmall = block.tileCentre.w < 0.5f && frame.pixelScale.x < 0.6f * block.cover.w / block.baseColour.w;
  return tooSmall ? Area{glm::vec2(1.0f), glm::vec2(-1.0f)} : area;
}

void fillRange(GrassBlock& block, const GrassLayout& layout, const shared::FrameBlock& frame) {
  const Area seen = seenArea(block, frame);
  const float reach = block.size.y;  // a blade may lean so far into another tile
  const auto tileAt = [&](glm::vec2 at) { return glm::floor(at / layout.tileSideM); };
  const glm::vec2 low = glm::max(tileAt(seen.low - reach), glm::vec2(layout.low));
  const glm::vec2 high = glm::min(tileAt(seen.high + reach), glm::vec2(layout.high));
  block.tileRange = {low, high};
  if (high.x < low.x || high.y < low.y) {
    block.tiles.z = -1.0f;
    return;
  }
  const glm::vec2 eye = tileAt(glm::vec2(frame.cameraPosition.x, frame.cameraPosition.z));
  const glm::vec2 centre = glm::clamp(eye, low, high);
  block.tileCentre.x = centre.x;
  block.tileCentre.y = centre.y;
  const glm::vec2 away = glm::max(centre - low, high - centre);
  block.tiles.z = std::max(away.x, away.y);
}

/// The meadow's own blades first, then the species that are blades.
int fillSpecies(GrassBlock& block, const GrassSettings& grass, std::span<const Species> species) {
  block.species[0] = {block.baseColour, block.tipColour, {grass.width, grass.stiffness, 1.0f, 0.0f}, glm::vec4(1.0f)};
  int count = 1;
  for (const Species& kind : species) {
    if (kind.shape != PlantShape::Blade || kind.hidden || kind.weight <= 0.0f || count == GRASS_SPECIES) continue;
    const std::uint32_t hash = hashCombine(kind.id, static_cast<std::uint32_t>(grass.seed));
    block.species[count++] = {{kind.baseColour, kind.height},
                              {kind.tipColour, kind.heightVariation},
                              {kind.width, kind.stiffness, kind.weight, kind.patchiness},
                              {kind.patchSize, hashToUnit(hash), hashToUnit(pcgHash(hash)), 0.0f}};
  }
  return count;
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
  layout.tileSideM = std::max(wanted, std::max(covered.x, covered.y) / static_cast<float>(kMaxTilesPerSide - 1));
  layout.low = glm::ivec2(glm::floor((field.centre - 0.5f * covered) / layout.tileSideM));
  layout.high = glm::ivec2(glm::floor((field.centre + 0.5f * covered) / layout.tileSideM));
  layout.bladesInTile = density * layout.tileSideM * layout.tileSideM;
  return layout;
}

std::vector<glm::vec2> groundInTiles(const GrassLayout& layout, const HeightField& ground) {
  std::vector<glm::vec2> bounds;
  for (int z = layout.low.y; z <= layout.high.y; ++z) {
    for (int x = layout.low.x; x <= layout.high.x; ++x) {
      const glm::vec2 low = layout.tileSideM * glm::vec2(x, z);
      const HeightRange range = heightsOver(ground, low, low + layout.tileSideM);
      bounds.emplace_back(range.lowest, range.highest);
    }
  }
  return bounds;
}

namespace {

/// Part of all plants that are blades: the density is shared by all species by their weights, hidden ones too.
float bladeShare(std::span<const Species> species) {
  float blades = 1.0f, all = 1.0f;
  for (const Species& kind : species) {
    const float weight = std::max(kind.weight, 0.0f);
    all += weight;
    if (kind.shape == PlantShape::Blade && !kind.hidden) blades += weight;
  }
  return blades / all;
}

}  // namespace

GrassBlock makeGrassBlock(const GrassSettings& grass, std::span<const Species> species, const GrassLayout& layout,
                          const GrassQuality& asked, const shared::FrameBlock& frame) {
  const float quality = std::clamp(asked.detail, 0.02f, 1.0f);
  const float density = shownDensity(grass);
  // Part of the ground that upright blades hide from a ray at 45 degrees.
  const float closed = 1.0f - std::exp(-1.3f * density * grass.width * grass.height);
  constexpr float kDeformations[] = {GRASS_DEFORMATION_ARC, GRASS_DEFORMATION_QUADRATIC, GRASS_DEFORMATION_INERTIAL};
  GrassBlock block{};
  block.baseColour = {grass.baseColour, grass.height};
  block.tipColour = {grass.tipColour, grass.heightVariation};
  block.dryColour = {grass.dryColour, grass.dryness};
  block.motion = {grass.windFactor / std::max(grass.stiffness, 1e-3f), grass.stiffnessVariation, grass.flutter,
                  grass.restBlend};
  block.droop = {grass.droopDown, grass.droopForward, density, static_cast<float>(grass.seed & 0xffffff)};
  block.shadow = {grass.shadowMin, grass.shadowMax, grass.shadowWind, grass.shadowOffset};
  const int kinds = fillSpecies(block, grass, species);
  float tallest = 0.01f;
  for (int i = 0; i < kinds; ++i) {
    tallest = std::max(tallest, block.species[i].base.w * (1.0f + block.species[i].tip.w) * 1.25f);
  }
  block.size = {grass.width, tallest, grass.clumping, kDeformations[static_cast<int>(grass.deformation)]};
  block.tiles = {layout.tileSideM, layout.bladesInTile * bladeShare(species), 0.0f, static_cast<float>(kinds)};
  block.tileCentre = {0.0f, 0.0f, kMeadowMarginM, asked.thinning ? 0.0f : 1.0f};
  block.boundsRange = {glm::vec2(layout.low), static_cast<float>(layout.tiles().x), asked.culling ? 1.0f : 0.0f};
  // At a low quality fewer layers rather than broad blades: the ground's shading stands for what is left out.
  const float least = std::min(kLeastPixels / std::pow(quality, 0.75f), kBroadestPixels);
  block.cover = {least, kMostWidening, kLayers * quality, kFadePixels / std::sqrt(quality)};
  const float coarser = asked.thinning ? 1.0f / std::sqrt(quality) : 0.0f;
  block.levels = {70.0f * coarser, 20.0f * coarser, closed, density * grass.width * grass.height};
  block.ground = {grass.slopeAlign, cosineOf(grass.slopeLimit), cosineOf(grass.slopeLimit - 15.0f), 0.0f};
  if (layout.empty()) {
    block.tiles.z = -1.0f;
  } else {
    fillRange(block, layout, frame);
  }
  return block;
}

std::uint32_t tilesInRings(const GrassBlock& block) {
  if (block.tiles.z < 0.0f) return 0;
  const std::uint32_t side = 2u * static_cast<std::uint32_t>(block.tiles.z) + 1u;
  return side * side;
}

double chunksInRange(const GrassBlock& block) {
  if (block.tiles.z < 0.0f) return 0;
  const glm::dvec4 range(block.tileRange);
  const double tiles = (range.z - range.x + 1) * (range.w - range.y + 1);
  return tiles * std::ceil((std::floor(static_cast<double>(block.tiles.y)) + 1) / GRASS_CHUNK);
}

float keptPart(const GrassBlock& block, float pixelsPerMetre, float facing) {
  if (block.tileCentre.w > 0.5f) return 1.0f;
  const float byLayers = shared::keptByLayers(shared::contourGain(facing, kContourLift), block.levels.w, block.cover.z);
  const float kept = shared::keptTogether(byLayers, block.size.x * pixelsPerMetre / block.cover.x) *
                     shared::keptByHeight(block.baseColour.w * pixelsPerMetre, block.cover.w);
  return std::min(kept, 1.0f);
}

}  // namespace windloom
