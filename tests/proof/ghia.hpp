#pragma once
// The lid-driven cavity and the table it is compared with: Ghia, Ghia & Shin, High-Re solutions for incompressible flow
// using the Navier-Stokes equations and a multigrid method, J. Comput. Phys. 48, 1982.

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/proof/cell_fields.hpp"

namespace windloom::testing {

struct GhiaPoint {
  std::string profile;  ///< "u" on the vertical, "v" on the horizontal centre line
  double reynolds, coordinate, value;
};

inline std::vector<GhiaPoint> ghiaTable() {
  std::ifstream file(std::string(WINDLOOM_TEST_DATA) + "/reference/ghia-1982.csv");
  std::vector<GhiaPoint> points;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line.starts_with("profile")) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    GhiaPoint p;
    fields >> p.profile >> p.reynolds >> p.coordinate >> p.value;
    points.push_back(p);
  }
  return points;
}

/// A unit square of no-slip walls whose upper one (zMax) moves along x at 1 m/s.
inline WindSetup cavitySetup(int cells, double reynolds) {
  const float h = 1.0f / static_cast<float>(cells);
  WindSetup setup = bareSetup({cells, cells}, h, Border::Wall, 0.8f * h);
  setup.solver.viscosity = static_cast<float>(1 / reynolds);
  setup.noSlip = WallSpeeds{0, 0, 0, 1};
  return setup;
}

/// The profile at a place 0..1 of a square field with an even number `n` of cells a side; walls themselves are known.
inline double onCentreLine(const CellField& cells, int n, const std::string& profile, double at) {
  const bool u = profile == "u";
  const auto value = [&](int j) {  // j-th row (u) or column (v) of cells
    if (j < 0) return 0.0;
    if (j >= n) return u ? 1.0 : 0.0;
    const auto cell = [&](int i, int k) { return cells[static_cast<std::size_t>(k * n + i)]; };
    return u ? 0.5 * double(cell(n / 2 - 1, j).x + cell(n / 2, j).x)
             : 0.5 * double(cell(j, n / 2 - 1).y + cell(j, n / 2).y);
  };
  const auto place = [&](int j) { return j < 0 ? 0.0 : j >= n ? 1.0 : (j + 0.5) / n; };
  const int low = std::clamp(static_cast<int>(std::floor(at * n - 0.5)), -1, n - 1);
  const double t = (at - place(low)) / (place(low + 1) - place(low));
  return std::lerp(value(low), value(low + 1), t);
}

}  // namespace windloom::testing
