#include "engine/bake/volume.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/contract.hpp"
#include "engine/core/text.hpp"

namespace windloom {
namespace {

constexpr float kHalfMost = 65504.0f;

/// A float as the double of its shortest decimal text, so that JSON has 0.1f as 0.1.
double plain(float value) {
  return parseNumber(shortest(value)).value_or(0.0);
}

glm::vec2 withinHalf(glm::vec2 vector) {
  const float greatest = std::max(std::abs(vector.x), std::abs(vector.y));
  return greatest > kHalfMost ? vector * (kHalfMost / greatest) : vector;
}

}  // namespace

nlohmann::ordered_json plainTriple(glm::vec3 value) {
  return {plain(value.x), plain(value.y), plain(value.z)};
}

VolumeLayers layersOf(const BakeHeader& header, int most) {
  HeightProfile profile = header.profile;
  WL_REQUIRE(profile.layers >= 1 && most >= 1, "a volume has a layer");
  profile.layers = std::min(profile.layers, most);
  VolumeLayers layers;
  const bool flat = profile.layers == 1;
  layers.high = flat ? 2.0f * profile.reference : profile.top;
  for (int n = 0; n < profile.layers; ++n) {
    const bool same = flat || header.track.quantity == Quantity::Bend;
    layers.factors.push_back(same ? 1.0f : profile.at(profile.heightOf(n)));
  }
  return layers;
}

Volume::Volume(const GridMapping& grid, VolumeLayers layers, Quantity quantity, Preset preset)
    : m_rules(rulesOf(preset)), m_plane(grid.resolution), m_layers(std::move(layers)), m_zUp(m_rules.up == "+Z") {
  WL_REQUIRE(!m_layers.factors.empty(), "a volume has a layer");
  const bool bend = quantity == Quantity::Bend;
  m_unit = bend ? "rad" : m_rules.speedUnit;
  m_unitFactor = bend ? 1.0f : m_rules.unitsPerMetre;
  const PresetBounds ground = boundsIn(m_rules, grid.minCorner, grid.size);
  const float low = m_layers.low * m_rules.unitsPerMetre, high = m_layers.high * m_rules.unitsPerMetre;
  if (m_zUp) {
    m_box = {{ground.min, low}, {ground.max, high}};
  } else {
    m_box = {{ground.min.x, low, ground.min.y}, {ground.max.x, high, ground.max.y}};
  }
}

glm::ivec3 Volume::size() const {
  const auto layers = static_cast<int>(m_layers.factors.size());
  return m_zUp ? glm::ivec3(m_plane, layers) : glm::ivec3(m_plane.x, layers, m_plane.y);
}

std::size_t Volume::cells() const {
  return static_cast<std::size_t>(m_plane.x) * static_cast<std::size_t>(m_plane.y) * m_layers.factors.size();
}

float Volume::fastestFactor() const {
  return *std::max_element(m_layers.factors.begin(), m_layers.factors.end());
}

void Volume::block(std::span<const glm::vec2> cells, std::vector<glm::vec3>& out) const {
  const auto width = static_cast<std::size_t>(m_plane.x), depth = static_cast<std::size_t>(m_plane.y);
  const std::size_t layers = m_layers.factors.size();
  WL_REQUIRE(cells.size() == width * depth, "a frame has the grid of its header");
  out.resize(this->cells());
  for (std::size_t k = 0; k < depth; ++k) {
    const glm::vec2* source = cells.data() + (m_rules.negateZ ? depth - 1 - k : k) * width;
    for (std::size_t layer = 0; layer < layers; ++layer) {
      const glm::vec2 signs(m_rules.negateX ? -1.0f : 1.0f, m_rules.negateZ ? -1.0f : 1.0f);
      const glm::vec2 factor = signs * (m_unitFactor * m_layers.factors[layer]);
      glm::vec3* row = out.data() + (m_zUp ? layer * depth + k : k * layers + layer) * width;
      for (std::size_t i = 0; i < width; ++i) {
        const glm::vec2 v = withinHalf(source[m_rules.negateX ? width - 1 - i : i] * factor);
        row[i] = m_zUp ? glm::vec3(v, 0.0f) : glm::vec3(v.x, 0.0f, v.y);
      }
    }
  }
}

nlohmann::ordered_json Volume::details(int frame) const {
  const glm::ivec3 cells = size();
  return {{"frame", frame},
          {"coordinates", {{"handedness", m_rules.handedness}, {"up", m_rules.up}}},
          {"units", m_unit},
          {"lengthUnit", m_rules.lengthUnit},
          {"grid", {cells.x, cells.y, cells.z}},
          {"order", "x fastest, then y, then z"},
          {"bounds", {{"min", plainTriple(m_box.min)}, {"max", plainTriple(m_box.max)}}}};
}

glm::ivec2 fittedResolution(glm::ivec2 resolution, int mostPerSide) {
  const int longer = std::max(resolution.x, resolution.y);
  if (longer <= mostPerSide) return resolution;
  const double scale = static_cast<double>(mostPerSide) / longer;
  const auto fit = [&](int side) { return std::clamp(static_cast<int>(std::lround(side * scale)), 1, mostPerSide); };
  return {fit(resolution.x), fit(resolution.y)};
}

std::string fittingWarning(const BakeHeader& header, int mostPerSide, const std::string& limitOf) {
  const glm::ivec2 from = header.grid.resolution, to = fittedResolution(from, mostPerSide);
  if (from == to) return {};
  return std::to_string(from.x) + " x " + std::to_string(from.y) + " cells are averaged down to " +
         std::to_string(to.x) + " x " + std::to_string(to.y) + ", " + limitOf;
}

FittedField::FittedField(const GridMapping& grid, int mostPerSide) : m_grid(grid) {
  const glm::ivec2 fitted = fittedResolution(grid.resolution, mostPerSide);
  if (fitted == grid.resolution) return;
  m_resampler.emplace(grid.resolution, fitted);
  m_grid.resolution = fitted;
  m_grid.cellSize = grid.size / glm::vec2(fitted);
}

std::span<const glm::vec2> FittedField::of(std::span<const glm::vec2> cells) {
  if (!m_resampler) return cells;
  m_resampler->apply(cells, m_fitted);
  return m_fitted;
}

}  // namespace windloom
