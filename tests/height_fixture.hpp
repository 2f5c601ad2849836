#pragma once
// Uneven ground for tests, made from a formula.

#include <functional>

#include "engine/model/project.hpp"

namespace windloom::testing {

/// Heights in m over a rectangle around the origin; a height map's values are kept as metres (factor 1).
inline std::shared_ptr<const HeightField> heightsFrom(glm::ivec2 samples, glm::vec2 size,
                                                      const std::function<float(glm::vec2)>& height) {
  auto source = std::make_shared<HeightSource>();
  source->file = "terrain/test.png";
  source->samples = source->pixels = samples;
  for (int k = 0; k < samples.y; ++k) {
    for (int i = 0; i < samples.x; ++i) {
      source->values.push_back(height(size * (glm::vec2(i, k) / glm::vec2(samples - 1) - 0.5f)));
      source->lowest = source->values.size() == 1 ? source->values.back() : std::min(source->lowest, source->values.back());
      source->highest = source->values.size() == 1 ? source->values.back() : std::max(source->highest, source->values.back());
    }
  }
  TerrainSettings terrain;
  terrain.kind = TerrainKind::HeightMap;
  terrain.file = source->file;
  terrain.size = size;
  terrain.height = 1.0f;
  return placeHeights(terrain, source);
}

/// A terrain part with these heights, as if read from its file.
inline std::shared_ptr<const TerrainSettings> terrainOf(std::shared_ptr<const HeightField> heights) {
  auto terrain = std::make_shared<TerrainSettings>();
  terrain->kind = heights->source->kind;
  terrain->file = heights->source->file;
  terrain->size = heights->size;
  terrain->height = heights->factor;
  terrain->heights = std::move(heights);
  return terrain;
}

}  // namespace windloom::testing
