#include "engine/model/height_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/model/project.hpp"

namespace windloom {
namespace {

/// Grid coordinates of a place, kept within the rectangle.
glm::vec2 gridPlace(const HeightField& field, glm::vec2 place) {
  const glm::vec2 last(field.source->samples - 1);
  return glm::clamp((place - field.low) / field.spacing(), glm::vec2(0.0f), last);
}

bool samePlace(const HeightField& a, const HeightField& b) {
  return a.low == b.low && a.size == b.size && a.base == b.base && a.factor == b.factor;
}

/// A ray over the grid, in grid coordinates along x and z and metres along y; t is in metres.
class GridRay {
 public:
  GridRay(const HeightField& field, glm::vec3 origin, glm::vec3 direction) : m_field(field) {
    const glm::dvec2 low(field.low), spacing(field.spacing());
    m_start = (glm::dvec2(origin.x, origin.z) - low) / spacing;
    m_along = glm::dvec2(direction.x, direction.z) / spacing;
    m_y = static_cast<double>(origin.y);
    m_yAlong = static_cast<double>(direction.y);
  }

  /// The first crossing from above to below between two distances.
  [[nodiscard]] std::optional<double> hit(double from, double to) const {
    double t = from;
    glm::ivec2 cell = cellAt(t);
    // At most every line of the grid is crossed once.
    const int most = m_field.source->samples.x + m_field.source->samples.y + 4;
    for (int step = 0; step < most && t < to; ++step) {
      const double next[2] = {lineAhead(0, cell.x), lineAhead(1, cell.y)};
      const int axis = next[0] <= next[1] ? 0 : 1;
      const double end = std::min(std::max(next[axis], t), to);
      if (const auto found = hitPatch(cell, t, end)) return found;
      t = end;
      cell[axis] += m_along[axis] > 0 ? 1 : -1;
    }
    return std::nullopt;
  }

 private:
  // Cells run from -1 (before the first sample) to samples - 1 (behind the last one).
  [[nodiscard]] glm::ivec2 cellAt(double t) const {
    glm::ivec2 cell;
    for (int axis = 0; axis < 2; ++axis) {
      const double at = std::floor(m_start[axis] + t * m_along[axis]);
      cell[axis] = static_cast<int>(std::clamp(at, -1.0, static_cast<double>(m_field.source->samples[axis] - 1)));
    }
    return cell;
  }

  /// Distance at which the ray leaves a cell along an axis.
  [[nodiscard]] double lineAhead(int axis, int cell) const {
    const int line = m_along[axis] > 0 ? cell + 1 : cell;
    const bool none = m_along[axis] == 0 || line < 0 || line > m_field.source->samples[axis] - 1;
    return none ? std::numeric_limits<double>::infinity() : (line - m_start[axis]) / m_along[axis];
  }

  /// Over one patch the height along the ray is a quadratic, and so is what the ray is above it.
  [[nodiscard]] std::optional<double> hitPatch(glm::ivec2 cell, double from, double to) const {
    const double middle = 0.5 * (from + to);
    const double a = above(cell, from), b = above(cell, middle), c = above(cell, to);
    // f(s) = a + q s + p s^2, s = 0..1.
    const double p = 2.0 * (a - 2.0 * b + c), q = 4.0 * b - 3.0 * a - c;
    if (a >= 0 && c >= 0 && (p <= 0 || a - q * q / (4.0 * p) > 0)) return std::nullopt;
    const double root = q * q - 4.0 * p * a;
    if (root < 0) return std::nullopt;
    // The root where the slope is negative: coming from above.
    const double slope = std::sqrt(root);
    const double denominator = q <= 0 ? slope - q : 0.0;
    double s = 0;
    if (q <= 0 && denominator > 0) {
      s = 2.0 * a / denominator;
    } else if (p < 0) {
      s = (-q - slope) / (2.0 * p);
    } else {
      return std::nullopt;
    }
    if (!(s >= -1e-9 && s <= 1.0 + 1e-9)) return std::nullopt;
    return from + std::clamp(s, 0.0, 1.0) * (to - from);
  }

  [[nodiscard]] double above(glm::ivec2 cell, double t) const {
    const glm::ivec2 last = m_field.source->samples - 1;
    const glm::dvec2 at = glm::clamp(m_start + t * m_along, glm::dvec2(0.0), glm::dvec2(last));
    const glm::ivec2 low = glm::clamp(cell, glm::ivec2(0), last), high = glm::min(low + 1, last);
    const glm::dvec2 f = glm::clamp(at - glm::dvec2(low), 0.0, 1.0);
    const auto h = [&](int i, int k) { return static_cast<double>(m_field.at(i, k)); };
    const double near = h(low.x, low.y) + f.x * (h(high.x, low.y) - h(low.x, low.y));
    const double far = h(low.x, high.y) + f.x * (h(high.x, high.y) - h(low.x, high.y));
    return m_y + t * m_yAlong - (near + f.y * (far - near));
  }

  const HeightField& m_field;
  glm::dvec2 m_start, m_along;
  double m_y, m_yAlong;
};

}  // namespace

float HeightField::lowest() const {
  return base + std::min(factor * source->lowest, factor * source->highest);
}

float HeightField::highest() const {
  return base + std::max(factor * source->lowest, factor * source->highest);
}

Shared<HeightField> placedHeights(const TerrainSettings& terrain) {
  if (!terrain.heights) return nullptr;
  Shared<HeightField> placed = placeHeights(terrain, terrain.heights->source);
  return placed && samePlace(*placed, *terrain.heights) ? terrain.heights : placed;
}

Shared<HeightField> placeHeights(const TerrainSettings& terrain, Shared<HeightSource> source) {
  if (!source || source->kind != terrain.kind || source->file != terrain.file) return nullptr;
  auto field = std::make_shared<HeightField>();
  if (terrain.kind == TerrainKind::Mesh) {
    field->low = terrain.centre + terrain.scale * source->low;
    field->size = terrain.scale * source->size;
    field->factor = terrain.scale;
  } else {
    field->low = terrain.centre - 0.5f * terrain.size;
    field->size = terrain.size;
    field->factor = terrain.height;
  }
  field->base = terrain.base;
  field->source = std::move(source);
  return field;
}

float heightAt(const HeightField& field, glm::vec2 place) {
  const glm::vec2 at = gridPlace(field, place);
  const glm::ivec2 low = glm::min(glm::ivec2(at), field.source->samples - 2);
  const glm::vec2 f = at - glm::vec2(low);
  const float near = glm::mix(field.at(low.x, low.y), field.at(low.x + 1, low.y), f.x);
  const float far = glm::mix(field.at(low.x, low.y + 1), field.at(low.x + 1, low.y + 1), f.x);
  return glm::mix(near, far, f.y);
}

glm::vec3 normalAt(const HeightField& field, glm::vec2 place) {
  const glm::vec2 step = field.spacing();
  const float x = heightAt(field, place - glm::vec2(step.x, 0)) - heightAt(field, place + glm::vec2(step.x, 0));
  const float z = heightAt(field, place - glm::vec2(0, step.y)) - heightAt(field, place + glm::vec2(0, step.y));
  return glm::normalize(glm::vec3(x / (2.0f * step.x), 1.0f, z / (2.0f * step.y)));
}

HeightRange heightsOver(const HeightField& field, glm::vec2 low, glm::vec2 high) {
  const glm::ivec2 last = field.source->samples - 1;
  const glm::ivec2 from = glm::ivec2(glm::floor(gridPlace(field, low)));
  const glm::ivec2 to = glm::min(glm::ivec2(glm::ceil(gridPlace(field, high))), last);
  HeightRange range{std::numeric_limits<float>::max(), std::numeric_limits<float>::lowest()};
  for (int k = from.y; k <= to.y; ++k) {
    for (int i = from.x; i <= to.x; ++i) {
      const float height = field.at(i, k);
      range.lowest = std::min(range.lowest, height);
      range.highest = std::max(range.highest, height);
    }
  }
  return range;
}

std::optional<float> hitHeights(const HeightField& field, glm::vec3 origin, glm::vec3 direction, float reach) {
  // Only between the lowest and the highest height is there something to meet.
  double from = 0, to = static_cast<double>(reach);
  const double y = static_cast<double>(origin.y), down = static_cast<double>(direction.y);
  const double margin = 1e-3 + 1e-5 * static_cast<double>(std::abs(field.highest()) + std::abs(field.lowest()));
  const double top = static_cast<double>(field.highest()) + margin, bottom = static_cast<double>(field.lowest()) - margin;
  if (down < 0) {
    from = std::max(from, (top - y) / down);
    to = std::min(to, (bottom - y) / down);
  } else if (down > 0) {
    to = std::min(to, (top - y) / down);
  } else if (y > top) {
    return std::nullopt;
  }
  if (!(from < to)) return std::nullopt;
  const auto hit = GridRay(field, origin, direction).hit(from, to);
  if (!hit) return std::nullopt;
  return static_cast<float>(*hit);
}

}  // namespace windloom
