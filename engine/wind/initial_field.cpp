#include "engine/wind/initial_field.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace windloom {
namespace {

constexpr int kMaxSide = 16384;

/// A line of `count` cells seen from face `face`: values, and which cells are there and hold air.
template <class Value, class Solid>
float faceOfLine(int face, int count, bool periodic, Value value, Solid solid) {
  const auto index = [&](int n) { return periodic ? ((n % count) + count) % count : n; };
  const auto air = [&](int n) { return (periodic || (n >= 0 && n < count)) && !solid(index(n)); };
  const int low = face - 1, high = face;
  if (!air(low)) return air(high) ? value(index(high)) : 0.0f;
  if (!air(high)) return value(index(low));
  if (air(low - 1) && air(high + 1)) {
    return 0.125f * (5 * (value(index(low)) + value(index(high))) - (value(index(low - 1)) + value(index(high + 1))));
  }
  return 0.5f * (value(index(low)) + value(index(high)));
}

}  // namespace

Status checkWindSetup(const WindSetup& setup) {
  const FieldSettings& field = setup.field;
  const auto positive = [](float value) { return std::isfinite(value) && value > 0; };
  if (!positive(field.size.x) || !positive(field.size.y))
    return makeError(ErrorKind::BadInput, "the field's size must be positive");
  if (!positive(field.timeStep)) return makeError(ErrorKind::BadInput, "the time step must be positive");
  if (std::min(field.resolution.x, field.resolution.y) < 1 ||
      std::max(field.resolution.x, field.resolution.y) > kMaxSide) {
    return makeError(ErrorKind::BadInput,
                     "the field's resolution must be 1 to " + std::to_string(kMaxSide) + " cells per side");
  }
  const auto paired = [](Border low, Border high) { return (low == Border::Periodic) == (high == Border::Periodic); };
  if (!paired(field.xMin, field.xMax) || !paired(field.zMin, field.zMax)) {
    return makeError(ErrorKind::BadInput, "a periodic border needs its opposite border to be periodic too");
  }
  return Done{};
}

Status checkInitialField(const WindGrid& grid, std::span<const glm::vec2> cells) {
  const std::size_t expected = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
  if (cells.size() != expected) {
    return makeError(ErrorKind::BadInput, "the initial wind has " + std::to_string(cells.size()) + " cells, expected " +
                                              std::to_string(grid.width) + " x " + std::to_string(grid.height));
  }
  const auto bad =
      std::find_if(cells.begin(), cells.end(), [](glm::vec2 v) { return !std::isfinite(v.x) || !std::isfinite(v.y); });
  if (bad == cells.end()) return Done{};
  const auto index = static_cast<std::size_t>(bad - cells.begin());
  return makeError(ErrorKind::BadInput,
                   "the initial wind of cell (" + std::to_string(index % static_cast<std::size_t>(grid.width)) + ", " +
                       std::to_string(index / static_cast<std::size_t>(grid.width)) + ") is not a finite number");
}

float initialFaceX(const WindGrid& grid, std::span<const glm::vec2> cells, int i, int k, float maxSpeed) {
  if (grid.blockedX(i, k)) return 0;
  const auto at = [&](int n) {
    return cells[static_cast<std::size_t>(k) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(n)].x;
  };
  return std::clamp(faceOfLine(i, grid.width, grid.periodicX(), at, [&](int n) { return grid.solidAt(n, k); }),
                    -maxSpeed, maxSpeed);
}

float initialFaceZ(const WindGrid& grid, std::span<const glm::vec2> cells, int i, int k, float maxSpeed) {
  if (grid.blockedZ(i, k)) return 0;
  const auto at = [&](int n) {
    return cells[static_cast<std::size_t>(n) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(i)].y;
  };
  return std::clamp(faceOfLine(k, grid.height, grid.periodicZ(), at, [&](int n) { return grid.solidAt(i, n); }),
                    -maxSpeed, maxSpeed);
}

}  // namespace windloom
