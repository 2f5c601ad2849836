#include "engine/grass/ground_area.hpp"

#include <algorithm>
#include <cmath>

#include "engine/grass/grass_layout.hpp"
#include "engine/grass/value_noise.hpp"

namespace windloom {
namespace {

constexpr double kLeastCells = 128.0 * 128.0, kMostCells = 512.0 * 512.0;
constexpr int kProbes = 3;          // along a cell's sides, where its growth is looked at
constexpr int kTries = 48;          // for a place in a cell where little grows
constexpr float kMapFadeM = 14.0f;  // as in shaders/include/grass_maps.glsl

float smooth(float low, float high, float value) {
  if (high <= low) return value >= high ? 1.0f : 0.0f;
  const float t = std::clamp((value - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// Brightness 0..1 of a map at a place of its own square, bilinear; as a texture that is clamped at its edges.
float lumaAt(const GrassMap& map, glm::vec2 part) {
  const glm::vec2 last = glm::vec2(map.size - 1);
  const glm::vec2 at = glm::clamp(part * glm::vec2(map.size) - 0.5f, glm::vec2(0.0f), last);
  const glm::ivec2 low = glm::ivec2(at), high = glm::min(low + 1, map.size - 1);
  const glm::vec2 f = at - glm::vec2(low);
  const auto luma = [&](int x, int y) {
    const std::uint8_t* pixel = &map.pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(map.size.x) +
                                                 static_cast<std::size_t>(x))];
    return (0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2]) / 255.0f;
  };
  return glm::mix(glm::mix(luma(low.x, low.y), luma(high.x, low.y), f.x),
                  glm::mix(luma(low.x, high.y), luma(high.x, high.y), f.x), f.y);
}

bool holds(const std::shared_ptr<const GrassMap>& map) {
  return map && map->size.x > 0 && map->size.y > 0 &&
         map->pixels.size() >= 4 * static_cast<std::size_t>(map->size.x) * static_cast<std::size_t>(map->size.y);
}

/// The byte 128 changes nothing, 255 doubles.
float aroundGrey(float value) {
  const float byte = 255.0f * value;
  return byte < 128.0f ? byte / 128.0f : 1.0f + (byte - 128.0f) / 127.0f;
}

struct GroundSample {
  float height = 0.0f;   // m
  float stretch = 1.0f;  // m^2 of ground over a level m^2
  glm::vec3 normal{0.0f, 1.0f, 0.0f};
};

/// What heightAt and normalAt give, and the stretch of the bilinear patch here, from twelve heights read once.
GroundSample sampleGround(const HeightField& field, glm::vec2 place) {
  const glm::ivec2 last = field.source->samples - 1;
  const glm::vec2 step = field.spacing();
  const glm::vec2 at = (place - field.low) / step, kept = glm::clamp(at, glm::vec2(0.0f), glm::vec2(last));
  const glm::ivec2 low = glm::min(glm::ivec2(kept), last - 1);
  const glm::vec2 f = kept - glm::vec2(low);
  const glm::ivec2 before = glm::max(low - 1, 0), after = glm::min(low + 2, last);
  const auto along = [&](int k) { return glm::mix(field.at(low.x, k), field.at(low.x + 1, k), f.x); };
  const auto across = [&](int i) { return glm::mix(field.at(i, low.y), field.at(i, low.y + 1), f.y); };
  const float left = across(low.x), right = across(low.x + 1), near = along(low.y), far = along(low.y + 1);
  GroundSample sample;
  sample.height = glm::mix(near, far, f.y);
  if (at != kept) {
    // Beyond its rectangle the ground goes on as its edge is.
    sample.normal = normalAt(field, place);
    sample.stretch = 1.0f / sample.normal.y;
    return sample;
  }
  const glm::vec2 slope = glm::vec2(right - left, far - near) / step;
  sample.stretch = std::sqrt(1.0f + glm::dot(slope, slope));
  const glm::vec2 fall(glm::mix(across(before.x), left, f.x) - glm::mix(right, across(after.x), f.x),
                       glm::mix(along(before.y), near, f.y) - glm::mix(far, along(after.y), f.y));
  sample.normal = glm::normalize(glm::vec3(fall.x / (2.0f * step.x), 1.0f, fall.y / (2.0f * step.y)));
  return sample;
}

float cosineOf(float degrees) {
  return std::cos(glm::radians(std::clamp(degrees, 0.0f, 90.0f)));
}

}  // namespace

GroundArea::GroundArea(const Project& project, double blades, ThreadPool& pool)
    : m_field(project.field),
      m_grass(project.grass),
      m_heights(project.terrain->heights),
      m_low(m_field->centre - 0.5f * m_field->size),
      m_high(m_field->centre + 0.5f * m_field->size),
      m_steep(cosineOf(m_grass->slopeLimit)),
      m_gentle(cosineOf(m_grass->slopeLimit - 15.0f)),
      m_seed(static_cast<std::uint32_t>(m_grass->seed)) {
  cut(std::clamp(blades / 32.0, kLeastCells, kMostCells));
  for (int p = 0; p < 2; ++p) {
    Part& part = m_parts[p];
    part.sums.resize(part.cells.size());
    constexpr int kChunk = 512;
    pool.parallelFor(static_cast<int>((part.cells.size() + kChunk - 1) / kChunk), [&](int chunk) {
      const std::size_t first = static_cast<std::size_t>(chunk) * kChunk;
      for (std::size_t i = first; i < std::min(first + kChunk, part.cells.size()); ++i)
        part.sums[i] = measure(part.cells[i], p);
    });
    for (double& sum : part.sums) sum = part.area += sum;
  }
}

/// About so many equal cells over the field, and as large ones over the margin; none lies in both.
void GroundArea::cut(double cells) {
  const glm::vec2 size = m_field->size;
  if (!(size.x > 0.0f) || !(size.y > 0.0f)) return;
  const float side = std::sqrt(size.x * size.y / static_cast<float>(cells));
  const glm::ivec2 inner = glm::clamp(glm::ivec2(glm::ceil(size / side)), glm::ivec2(1), glm::ivec2(4096));
  const int rim = std::clamp(static_cast<int>(std::ceil(kMeadowMarginM / side)), 8, 64);
  const auto edge = [&](int axis, int i) {
    if (i <= rim) return m_low[axis] - kMeadowMarginM * static_cast<float>(rim - i) / static_cast<float>(rim);
    if (i < rim + inner[axis])
      return m_low[axis] + size[axis] * static_cast<float>(i - rim) / static_cast<float>(inner[axis]);
    return m_high[axis] + kMeadowMarginM * static_cast<float>(i - rim - inner[axis]) / static_cast<float>(rim);
  };
  for (int k = 0; k < inner.y + 2 * rim; ++k) {
    for (int i = 0; i < inner.x + 2 * rim; ++i) {
      const glm::vec2 low(edge(0, i), edge(1, k)), high(edge(0, i + 1), edge(1, k + 1));
      const bool field = i >= rim && k >= rim && i < rim + inner.x && k < rim + inner.y;
      m_parts[field ? 0 : 1].cells.push_back({low, high - low});
    }
  }
}

bool GroundArea::even(int part) const {
  return part == 0 && !m_heights && !holds(m_grass->densityPixels);
}

/// Area of a cell weighted with what grows; keeps its upper bound.
double GroundArea::measure(Cell& cell, int part) const {
  const double level = static_cast<double>(cell.size.x) * static_cast<double>(cell.size.y);
  if (even(part)) {
    cell.most = 0.0f;
    return level;
  }
  double sum = 0;
  float most = 0.0f;
  for (int k = 0; k < kProbes; ++k) {
    for (int i = 0; i < kProbes; ++i) {
      const float weight =
          growthAt(cell.low + cell.size * (glm::vec2(i, k) + 0.5f) / static_cast<float>(kProbes), part).weight;
      sum += static_cast<double>(weight);
      most = std::max(most, weight);
    }
  }
  // The bound allows for what lies between the probes.
  cell.most = 1.25f * most;
  return level * sum / (kProbes * kProbes);
}

/// How far in the margin, 0..1 and more; ragged.
float GroundArea::margin(glm::vec2 place) const {
  const float beyond = glm::length(glm::max(glm::max(m_low - place, place - m_high), glm::vec2(0.0f)));
  if (beyond <= 0.0f) return 0.0f;
  const float noise = 0.6f * valueNoise(place / 6.3f, m_seed ^ 0x5bd1e995u) + 0.4f * valueNoise(place / 2.1f, m_seed);
  return std::max(beyond / kMeadowMarginM + 0.9f * (noise - 0.5f), 0.0f);
}

GroundArea::Growth GroundArea::growthAt(glm::vec2 place, int part) const {
  Growth growth;
  if (part == 1) {
    // Thinner than the instanced grass's: each blade costs memory and time here.
    const float left = std::max(1.0f - margin(place), 0.0f);
    growth.grown = left * left;
    if (growth.grown <= 0.0f) return {.grown = 0.0f, .weight = 0.0f};
  }
  if (holds(m_grass->densityPixels)) {
    const float beyond = glm::length(glm::max(glm::max(m_low - place, place - m_high), glm::vec2(0.0f)));
    const float luma = lumaAt(*m_grass->densityPixels, (place - m_low) / m_field->size);
    growth.grown *= glm::mix(luma, 1.0f, smooth(0.0f, kMapFadeM, beyond));
  }
  growth.weight = growth.grown;
  if (m_heights) {
    const GroundSample ground = sampleGround(*m_heights, place);
    growth.height = ground.height;
    growth.normal = ground.normal;
    growth.grown *= smooth(m_steep, m_gentle, growth.normal.y);
    growth.weight = growth.grown * ground.stretch;
  }
  return growth;
}

GrowthPoint GroundArea::pointAt(glm::vec2 place, const Growth& growth, int part) const {
  GrowthPoint point;
  point.place = {place.x, growth.height, place.y};
  point.up = glm::normalize(glm::mix(glm::vec3(0.0f, 1.0f, 0.0f), growth.normal, m_grass->slopeAlign));
  point.grown = growth.grown;
  if (part == 1) point.lushness = glm::mix(1.0f, 0.3f, smooth(0.0f, 0.8f, margin(place)));
  if (holds(m_grass->heightPixels)) {
    const float beyond = glm::length(glm::max(glm::max(m_low - place, place - m_high), glm::vec2(0.0f)));
    const float factor = aroundGrey(lumaAt(*m_grass->heightPixels, (place - m_low) / m_field->size));
    point.lushness *= glm::mix(factor, 1.0f, smooth(0.0f, kMapFadeM, beyond));
  }
  point.lushness *= 1.0f + 0.5f * m_grass->clumping * (valueNoise(place / 4.5f, m_seed ^ 0x2c1b3c6du) - 0.5f);
  return point;
}

GrowthPoint GroundArea::at(int partIndex, double along, RandomStream& random) const {
  const Part& part = m_parts[partIndex];
  const auto found = std::upper_bound(part.sums.begin(), part.sums.end() - 1, along * part.area);
  const Cell& cell = part.cells[static_cast<std::size_t>(found - part.sums.begin())];
  const auto anywhere = [&] {
    const float x = random.next();
    return cell.low + cell.size * glm::vec2(x, random.next());
  };
  if (cell.most == 0.0f) return pointAt(anywhere(), Growth{}, partIndex);
  glm::vec2 best(0.0f);
  Growth most{.weight = -1.0f};
  for (int i = 0; i < kTries; ++i) {
    const glm::vec2 place = anywhere();
    const Growth growth = growthAt(place, partIndex);
    if (random.next() * cell.most < growth.weight) return pointAt(place, growth, partIndex);
    if (growth.weight > most.weight) {
      most = growth;
      best = place;
    }
  }
  return pointAt(best, most, partIndex);
}

bool GroundArea::within(glm::vec2 place, int part) const {
  const float rim = part == 0 ? 0.0f : kMeadowMarginM;
  const bool inField = glm::all(glm::greaterThanEqual(place, m_low)) && glm::all(glm::lessThan(place, m_high));
  if (part == 0) return inField;
  return !inField && glm::all(glm::greaterThanEqual(place, m_low - rim)) &&
         glm::all(glm::lessThan(place, m_high + rim));
}

std::optional<GrowthPoint> GroundArea::beside(int part, const GrowthPoint& from, glm::vec3 offset,
                                              RandomStream& random) const {
  const glm::vec2 place(from.place.x + offset.x, from.place.z + offset.z);
  if (!within(place, part)) return std::nullopt;
  const Growth growth = even(part) ? Growth{} : growthAt(place, part);
  if (random.next() * from.grown >= growth.grown) return std::nullopt;
  return pointAt(place, growth, part);
}

}  // namespace windloom
