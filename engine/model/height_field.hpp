#pragma once
// The shape of uneven ground: a regular grid of heights over a rectangle of the world.
//
// Sample (i, k) stands at the low corner plus (i, k) times the spacing, so the first and the last sample of a
// row lie on the rectangle's edges. Between samples the height is bilinear; outside the rectangle the height of
// the nearest place on its edge goes on.

#include <cstddef>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace windloom {

enum class TerrainKind {
  Flat,
  HeightMap,  ///< grey picture
  Mesh,       ///< glTF, seen from above
};
struct TerrainSettings;

inline constexpr int kMaxHeightSamples = 2048;  ///< per side

/// What a terrain file gave, before it is placed in the world.
struct HeightSource {
  TerrainKind kind = TerrainKind::HeightMap;
  std::string file;               ///< TerrainSettings::file that it was read from
  glm::ivec2 samples{0};          ///< along x and z, 2..kMaxHeightSamples
  std::vector<float> values;      ///< samples.x a row, rows along +z; height map: 0 black..1 white; mesh: m
  float lowest = 0, highest = 0;  ///< of `values`
  glm::vec2 low{0.0f}, size{1.0f};  ///< mesh: the rectangle in its own metres
  glm::ivec2 pixels{0};           ///< of the picture; 0 for a mesh
  std::size_t triangles = 0;      ///< of the mesh
};

/// A source at its place. Small: the samples are shared.
struct HeightField {
  std::shared_ptr<const HeightSource> source;  ///< never null
  glm::vec2 low{0.0f}, size{1.0f};             ///< m
  float base = 0, factor = 1;                  ///< height = base + factor * value, m

  [[nodiscard]] glm::vec2 spacing() const { return size / glm::vec2(source->samples - 1); }
  [[nodiscard]] float at(int i, int k) const {
    return base + factor * source->values[static_cast<std::size_t>(k) * static_cast<std::size_t>(source->samples.x) +
                                          static_cast<std::size_t>(i)];
  }
  [[nodiscard]] float lowest() const;
  [[nodiscard]] float highest() const;
  [[nodiscard]] std::size_t bytes() const { return source->values.size() * sizeof(float); }
};

/// Where `terrain` wants its heights: the field it has where that is right already, another one of the same
/// source, or null where it has none or one of another kind or file.
std::shared_ptr<const HeightField> placedHeights(const TerrainSettings& terrain);
/// The same with a source that was just read. Null where kind or file don't fit.
std::shared_ptr<const HeightField> placeHeights(const TerrainSettings& terrain,
                                                std::shared_ptr<const HeightSource> source);

/// m. Everywhere, also outside the rectangle.
float heightAt(const HeightField& field, glm::vec2 place);
/// Unit vector, up; from heights one spacing around.
glm::vec3 normalAt(const HeightField& field, glm::vec2 place);

struct HeightRange {
  float lowest = 0, highest = 0;  ///< m
};
/// Bounds of the height over a rectangle; exact up to one spacing around it.
HeightRange heightsOver(const HeightField& field, glm::vec2 low, glm::vec2 high);

/// Distance along a ray (unit direction) to the first place where it comes from above to below the ground,
/// 0..reach m. Exact: every patch between samples is solved. Takes time in proportion to the samples crossed.
std::optional<float> hitHeights(const HeightField& field, glm::vec3 origin, glm::vec3 direction, float reach);

}  // namespace windloom
