#include "engine/grass/plant_layout.hpp"

#include <algorithm>
#include <cmath>

#include "engine/grass/grass_layout.hpp"
#include "shaders/shared/hash.h"

namespace windloom {
namespace {

constexpr float kPlantsInCell = 768.0f;
constexpr int kLeastSideLog = 0, kMostSideLog = 6;  // cells of 1 m to 64 m
// Mean of patchAt() in place_plants.comp.
constexpr float kPatchMean = 0.4f;
// Plants narrower than this on screen, pixels, are thinned out and widened, at most so much.
constexpr float kLeastPixels = 1.5f, kMostWidening = 2.6f;
constexpr float kGonePixels = 1.6f;
// A mesh is drawn in full from this many pixels on; one of many triangles from more.
constexpr float kNearPixels = 85.0f, kMostNearPixels = 600.0f;
constexpr glm::uvec2 kMostRoom{60'000u, 500'000u};

float shareOf(const std::vector<Species>& species) {
  float sum = 1.0f;
  for (const Species& one : species) sum += std::max(one.weight, 0.0f);
  return 1.0f / sum;
}

/// Half of the widest part over the height.
float widestPart(const PlantMeshSummary& mesh) {
  const float x = std::max(mesh.high.x, -mesh.low.x), z = std::max(mesh.high.z, -mesh.low.z);
  return 2.0f * std::max(x, z) / std::max(mesh.high.y, 1e-6f);
}

/// What of a plant is seen from afar: a flower's head, a mesh's body.
float seenWidth(const Species& species, const PlantMeshSummary& mesh) {
  switch (species.shape) {
    case PlantShape::Daisy:
      return 0.12f;
    case PlantShape::Poppy:
      return 0.16f;
    case PlantShape::Spike:
      return 0.14f;
    default:
      return std::clamp(0.7f * widestPart(mesh), 0.05f, 2.0f);
  }
}

}  // namespace

float ownShare(const std::vector<Species>& species) {
  return shareOf(species);
}

float plantDensity(const GrassSettings& grass, const std::vector<Species>& species, std::size_t index) {
  return shownDensity(grass) * std::max(species[index].weight, 0.0f) * shareOf(species);
}

std::vector<std::size_t> meshSpecies(const GrassSettings& grass, const std::vector<Species>& species) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < species.size() && found.size() < PLANT_KINDS; ++i) {
    const Species& one = species[i];
    const bool there = one.shape != PlantShape::Mesh || (one.mesh && !one.mesh->indices.empty());
    if (one.shape != PlantShape::Blade && !one.hidden && there && plantDensity(grass, species, i) > 0.0f)
      found.push_back(i);
  }
  return found;
}

PlantKind makePlantKind(const GrassSettings& grass, const std::vector<Species>& species, std::size_t index,
                        const PlantMeshSummary& mesh) {
  const Species& one = species[index];
  const bool builtIn = one.shape != PlantShape::Mesh;
  const float height = std::max(one.height, 0.01f);
  const float patchiness = std::clamp(one.patchiness, 0.0f, 1.0f);
  // As many plants in all, however patchy.
  const float candidates = plantDensity(grass, species, index) / glm::mix(1.0f, kPatchMean, patchiness);
  const auto sideLog = static_cast<int>(std::lround(0.5f * std::log2(kPlantsInCell / std::max(candidates, 1e-6f))));
  const float side = std::exp2(static_cast<float>(std::clamp(sideLog, kLeastSideLog, kMostSideLog)));
  const float triangles = static_cast<float>(mesh.triangles);
  PlantKind kind{};
  kind.size = {height, std::clamp(one.heightVariation, 0.0f, 1.0f), height / std::max(mesh.high.y, 1e-6f),
               seenWidth(one, mesh)};
  kind.growth = {candidates * side * side, patchiness, std::max(one.patchSize, 0.1f), side};
  kind.motion = {grass.windFactor / std::max(one.stiffness, 1e-3f), grass.stiffnessVariation, grass.flutter,
                 grass.slopeAlign};
  kind.levels = {std::clamp(5.0f * std::sqrt(triangles), kNearPixels, kMostNearPixels), kLeastPixels, kGonePixels,
                 kMostWidening};
  // A built-in flower has its colours in its mesh.
  kind.tint = glm::vec4(builtIn ? glm::vec3(1.0f) : one.tipColour, builtIn ? 1.0f : 0.0f);
  kind.seed = shared::hashCombine(static_cast<std::uint32_t>(one.id), static_cast<std::uint32_t>(grass.seed));
  return kind;
}

glm::uvec2 plantRoom(const PlantKind& kind, const FieldSettings& field) {
  const glm::vec2 covered = field.size + 2.0f * kMeadowMarginM + 2.0f * kind.growth.w;
  const double cells = static_cast<double>(covered.x) * static_cast<double>(covered.y) /
                       (static_cast<double>(kind.growth.w) * static_cast<double>(kind.growth.w));
  const double most = std::ceil(cells * std::ceil(static_cast<double>(kind.growth.x) + 1.0));
  const auto bounded = [&](std::uint32_t limit) {
    return static_cast<std::uint32_t>(std::min(most, static_cast<double>(limit)));
  };
  return {bounded(kMostRoom.x), bounded(kMostRoom.y)};
}

PlantCells cellsInReach(const PlantKind& kind, const FieldSettings& field, const PlantView& view) {
  glm::vec2 low = field.centre - 0.5f * field.size - kMeadowMarginM;
  glm::vec2 high = field.centre + 0.5f * field.size + kMeadowMarginM;
  if (!view.orthographic && view.thinning) {
    // keptPlants() is 0 from here on.
    const float reach = kind.size.x * view.pixelScale / kind.levels.z;
    const glm::vec2 eye(view.eye.x, view.eye.z);
    low = glm::max(low, eye - 1.5f * reach);
    high = glm::min(high, eye + 1.5f * reach);
  }
  PlantCells cells;
  if (low.x >= high.x || low.y >= high.y) return cells;
  cells.first = glm::ivec2(glm::floor(low / kind.growth.w));
  cells.count = glm::ivec2(glm::ceil(high / kind.growth.w)) - cells.first;
  return cells;
}

}  // namespace windloom
