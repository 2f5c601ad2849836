// Draws the pictures of docs/solver.md with the CPU backend: solver_pictures FOLDER
#include <cstdio>
#include <filesystem>
#include <optional>

#include "engine/io/project_json.hpp"
#include "engine/session/simulation.hpp"
#include "tests/proof/field_picture.hpp"
#include "tests/proof/ghia.hpp"

namespace windloom::testing {
namespace {

/// dw/dx - du/dz of the faces themselves at node (i, k), 1/s: nothing that alternates from cell to cell is averaged
/// away. None on borders, and beside solids, where half of it would be the steps of the grid.
std::optional<double> nodeVorticity(const CpuFields& f, int i, int k) {
  const WindGrid& g = f.grid;
  if (i <= 0 || k <= 0 || i >= g.width || k >= g.height) return std::nullopt;
  if (g.solidAt(i, k) || g.solidAt(i - 1, k) || g.solidAt(i, k - 1) || g.solidAt(i - 1, k - 1)) return std::nullopt;
  return double(f.velocity.w.at(i, k) - f.velocity.w.at(i - 1, k)) / double(g.hx) -
         double(f.velocity.u.at(i, k) - f.velocity.u.at(i, k - 1)) / double(g.hz);
}

/// Bilinear between the four nodes around a place that have a vorticity; where none has one, from the next ones.
double vorticityAt(const CpuFields& f, glm::vec2 world) {
  const glm::dvec2 at = glm::dvec2(world - f.grid.mapping.minCorner) / glm::dvec2(f.grid.mapping.cellSize);
  const glm::ivec2 low(glm::floor(at));
  for (const int reach : {0, 1}) {
    double sum = 0, weights = 0;
    for (int k = low.y - reach; k <= low.y + 1 + reach; ++k) {
      for (int i = low.x - reach; i <= low.x + 1 + reach; ++i) {
        const double weight =
            std::max(1 + reach - std::abs(at.x - i), 0.0) * std::max(1 + reach - std::abs(at.y - k), 0.0);
        if (const auto value = nodeVorticity(f, i, k)) sum += weight * *value, weights += weight;
      }
    }
    if (weights > 1e-6) return sum / weights;
  }
  return 0;
}

struct Shown {
  std::string name;
  glm::vec2 low, high;  // m
  int width;            // pixels
  double speed, turning;
};

/// solver-NAME-speed.png and solver-NAME-vorticity.png.
Status draw(const std::filesystem::path& folder, const Shown& shown, CpuWindSolver& solver) {
  const CellField cells = readCells(solver);
  const CpuFields& fields = solver.fields();
  FieldPicture picture{shown.low, shown.high, shown.width, ColourMap::Speed, shown.speed, "m/s"};
  const Image speed = drawField(picture, fields.grid, [&](glm::vec2 world) {
    return double(glm::length(sampleCells(cells, solver.grid(), world)));
  });
  picture.map = ColourMap::Turning;
  picture.range = shown.turning;
  picture.unit = "1/s";
  const Image turning = drawField(picture, fields.grid, [&](glm::vec2 world) { return vorticityAt(fields, world); });
  std::printf("%s: fastest %.2f m/s\n", shown.name.c_str(), solver.diagnostics().maxSpeed);
  if (Status written = writePng(folder / ("solver-" + shown.name + "-speed.png"), speed); !written) return written;
  return writePng(folder / ("solver-" + shown.name + "-vorticity.png"), turning);
}

Status drawCavity(const std::filesystem::path& folder) {
  constexpr int kCells = 128;
  const WindSetup setup = cavitySetup(kCells, 400);
  CpuWindSolver solver(setup, 0);
  run(solver, static_cast<int>(30 / setup.field.timeStep));
  return draw(folder, {"cavity", {0, 0}, {1, 1}, 480, 1, 5}, solver);
}

Status drawTaylorGreen(const std::filesystem::path& folder) {
  constexpr int kCells = 256;
  const WindSetup setup = bareSetup({kCells, kCells}, 1, Border::Wall, 0.1f);
  CpuWindSolver solver(setup, 0);
  if (Status set = solver.setVelocity(cellsOf(setup, taylorGreen(kCells, 1, 10))); !set) return set;
  run(solver, 200);
  return draw(folder, {"taylor-green", {0, 0}, {kCells, kCells}, 480, 10, 0.25}, solver);
}

Status drawSample(const std::filesystem::path& folder, double seconds, const Shown& shown) {
  const auto loaded = loadProject(std::filesystem::path(WINDLOOM_PROJECTS) / shown.name / (shown.name + ".wind.json"));
  if (!loaded) return loaded.error();
  SimulationOptions options;
  options.backend = Backend::Cpu;
  auto made = Simulation::create(loaded->project, options);
  if (!made) return made.error();
  (*made)->runTo(seconds);
  return draw(folder, shown, dynamic_cast<CpuWindSolver&>((*made)->solver()));
}

Status drawAll(const std::filesystem::path& folder) {
  if (Status drawn = drawCavity(folder); !drawn) return drawn;
  if (Status drawn = drawTaylorGreen(folder); !drawn) return drawn;
  if (Status drawn = drawSample(folder, 8, {"colliding-winds", {-40, -40}, {40, 40}, 560, 16, 8}); !drawn) return drawn;
  return drawSample(folder, 20, {"canyon", {2, -19}, {60, 19}, 640, 16, 12});
}

}  // namespace
}  // namespace windloom::testing

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: solver_pictures FOLDER\n");
    return 2;
  }
  const windloom::Status drawn = windloom::testing::drawAll(arguments[1]);
  if (!drawn) std::fprintf(stderr, "%s\n", drawn.error().text().c_str());
  return drawn ? 0 : 3;
}
