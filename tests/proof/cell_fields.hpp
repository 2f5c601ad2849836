#pragma once
// Cell-centred fields, the one form of the wind that both backends take and give, and measures of them.

#include <cstring>

#include "tests/unit/wind/wind_fixture.hpp"

namespace windloom::testing {

using CellField = std::vector<glm::vec2>;
using Flow = std::function<glm::dvec2(double x, double z)>;

inline CellField readCells(WindSolver& solver) {
  CellField cells;
  solver.readVelocity(cells);
  return cells;
}

/// What a solver whose faces hold `flow` exactly shows as its cells: the means of opposite faces.
inline CellField cellsOf(const WindSetup& setup, const Flow& flow) {
  const glm::ivec2 n = setup.field.resolution;
  const glm::dvec2 h = glm::dvec2(setup.field.size) / glm::dvec2(n),
                   low = glm::dvec2(setup.field.centre) - glm::dvec2(setup.field.size) / 2.0;
  CellField cells;
  cells.reserve(static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y));
  for (int k = 0; k < n.y; ++k) {
    for (int i = 0; i < n.x; ++i) {
      const double x = low.x + i * h.x, z = low.y + k * h.y, mx = x + h.x / 2, mz = z + h.y / 2;
      cells.emplace_back((flow(x, mz).x + flow(x + h.x, mz).x) / 2, (flow(mx, z).y + flow(mx, z + h.y).y) / 2);
    }
  }
  return cells;
}

inline CellField scaled(CellField cells, double factor) {
  for (glm::vec2& v : cells) v = glm::vec2(glm::dvec2(v) * factor);
  return cells;
}

/// Sum of |u|^2.
inline double energyOf(const CellField& cells) {
  double sum = 0;
  for (const glm::dvec2 v : cells) sum += glm::dot(v, v);
  return sum;
}

/// L2 norm of a - b, as a part of that of b. NaN where a has one, which no comparison lets pass.
inline double relativeDifference(const CellField& a, const CellField& b) {
  double difference = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    const glm::dvec2 d = glm::dvec2(a[n]) - glm::dvec2(b[n]);
    difference += glm::dot(d, d);
  }
  return std::sqrt(difference / energyOf(b));
}

/// Greatest difference of a component from a uniform wind, m/s.
inline double greatestDifference(const CellField& cells, glm::vec2 expected) {
  double greatest = 0;
  for (const glm::vec2 v : cells) {
    for (const float d : {v.x - expected.x, v.y - expected.y}) {
      if (!(double(std::abs(d)) <= greatest)) greatest = double(std::abs(d));  // a NaN stays
    }
  }
  return greatest;
}

inline bool sameBytes(const CellField& a, const CellField& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec2)) == 0;
}

}  // namespace windloom::testing
