#include <cmath>

#include "engine/cli/bench.hpp"
#include "engine/cli/bench_project.hpp"
#include "engine/cli/bench_timing.hpp"
#include "engine/cli/wind_context.hpp"
#include "engine/core/thread_pool.hpp"
#include "engine/wind/plain_scheme.hpp"

namespace windloom::cli {
namespace {

std::string sizeText(int cells) {
  return std::to_string(cells) + " x " + std::to_string(cells);
}

BenchRow rowOf(const char* where, int cells, const char* scheme, double ms, int runs) {
  return {{"where", where},
          {"cells", sizeText(cells)},
          {"scheme", scheme},
          {"ms", ms},
          {"ns a cell", ms * 1e6 / (static_cast<double>(cells) * cells)},
          {"runs", runs}};
}

/// The unit in which CPU steps are told, since it follows the machine's speed.
Measured jacobiSweep(int cells, double capSeconds) {
  const std::size_t count = static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells);
  std::vector<float> p(count, 0.0f), next(count, 0.0f);
  const std::vector<float> divergence(count, 1.0f);
  ThreadPool pool;
  return measure({3, 10, 60, capSeconds}, [&] {
    return wallMs([&] {
      plainJacobiSweep(pool, cells, cells, p, divergence, next);
      p.swap(next);
    });
  });
}

/// What the projections left of the divergence, as parts of what there was.
struct Residuals {
  std::vector<double> values;
  void add(const WindDiagnostics& d) {
    // On the GPU the first steps' numbers haven't arrived yet.
    if (d.divergenceBefore > 0) values.push_back(d.divergenceAfter / d.divergenceBefore);
  }
};

void describe(BenchRow& row, WindSolver& solver, int arrows, const Residuals& residuals) {
  const WindDiagnostics& d = solver.diagnostics();
  row["arrows"] = arrows;
  if (!residuals.values.empty()) row["residual"] = median(residuals.values);
  row["cycles"] = d.cycles;
  row["MiB"] = static_cast<double>(solver.memoryBytes()) / (1 << 20);
  row["cfl"] = d.cfl;
  row["not finite"] = d.nonFiniteCells;
  row["stages"] = Json::object();
  for (const auto& [stage, ms] : d.stageMs) row["stages"][stage] = ms;
  row["last step"] = diagnosticsJson(d);
}

Result<BenchRow> cpuStep(const BenchSetup& setup, int cells, int arrows, double sweepMs) {
  const Project project = benchProject(cells, arrows);
  Result<std::unique_ptr<Simulation>> simulation = makeSimulation(project, Backend::Cpu, {}, 0);
  if (!simulation) return simulation.error();
  Residuals residuals;
  const Measured step = measure({10, 5, 60, setup.capSeconds}, [&] {
    const double ms = wallMs([&] { (*simulation)->step(); });
    residuals.add((*simulation)->solver().diagnostics());
    return ms;
  });
  BenchRow row = rowOf("cpu", cells, "windloom", step.median, step.runs);
  describe(row, (*simulation)->solver(), arrows, residuals);
  row["sweeps"] = step.median / sweepMs;
  return row;
}

/// The row of a GPU scheme: batches of steps between two timestamps, so that nothing waits inside.
BenchRow gpuSteps(const BenchSetup& setup, int cells, const char* scheme, const std::function<void()>& step,
                  const std::function<void()>& afterBatch) {
  const bool software = setup.context->info().software;
  const int batch = software ? 1 : 20;
  // A GPU that idled, and programs that are new to its driver, are slow for a second.
  const double warmUpMs = software || setup.size == BenchSize::Quick ? 0 : 1500;
  for (double spent = 0; spent < warmUpMs;) {
    spent += wallMs([&] {
      for (int i = 0; i < 100; ++i) step();
      glFinish();
    });
  }
  std::vector<double> wall;
  const Measured m = measure({3, 5, 20, setup.capSeconds}, [&] {
    double ms = 0;
    const auto steps = [&] {
      for (int i = 0; i < batch; ++i) step();
    };
    wall.push_back(wallMs([&] { ms = gpuMs(steps); }) / batch);
    afterBatch();
    return ms / batch;
  });
  BenchRow row = rowOf("gpu", cells, scheme, m.median, m.runs * batch);
  row["wall ms"] = median(wall);
  return row;
}

Result<BenchRow> gpuStep(const BenchSetup& setup, int cells, int arrows) {
  const Project project = benchProject(cells, arrows);
  SimulationOptions options;
  options.backend = Backend::Gpu;
  options.context = setup.context;
  options.shaders = setup.shaders;
  Result<std::unique_ptr<Simulation>> simulation = Simulation::create(project, options);
  if (!simulation) return simulation.error();
  WindSolver& solver = (*simulation)->solver();
  Residuals residuals;
  BenchRow row = gpuSteps(
      setup, cells, "windloom", [&] { (*simulation)->step(); }, [&] { residuals.add(solver.diagnostics()); });
  describe(row, solver, arrows, residuals);
  return row;
}

/// The paper's scheme on the same machine: 20 Jacobi sweeps, one a dispatch.
Result<BenchRow> gpuPlainStep(const BenchSetup& setup, int cells) {
  Result<PlainScheme> plain = PlainScheme::create(*setup.shaders, {cells, cells});
  if (!plain) return plain.error();
  constexpr float kTimeStep = 1.0f / 60.0f;
  BenchRow row = gpuSteps(
      setup, cells, "plain, 20 Jacobi sweeps", [&] { plain->step(kTimeStep); }, [] {});
  const auto [before, after] = plain->measureStep(kTimeStep);
  row["residual"] = before > 0 ? after / before : 0.0;
  row["MiB"] = static_cast<double>(plain->memoryBytes()) / (1 << 20);
  return row;
}

}  // namespace

Result<std::vector<BenchRow>> benchSolver(const BenchSetup& setup) {
  const bool quick = setup.size == BenchSize::Quick;
  const std::vector<int> usual = quick ? std::vector<int>{64} : std::vector<int>{256, 512, 1000, 2048, 4096};
  const std::vector<int>& sizes = setup.cells.empty() ? usual : setup.cells;
  const int manyArrowsAt = quick ? 64 : 1000;
  std::vector<BenchRow> rows;
  const auto add = [&](Result<BenchRow> row) -> Status {
    if (!row) return row.error();
    rows.push_back(std::move(*row));
    return Done{};
  };
  for (const int cells : sizes) {
    std::vector<int> arrowCounts = {10};
    if (cells == manyArrowsAt) arrowCounts.push_back(quick ? 100 : 10'000);
    if (setup.cpu) {
      const Measured sweep = jacobiSweep(cells, setup.capSeconds);
      rows.push_back(rowOf("cpu", cells, "one plain Jacobi sweep", sweep.median, sweep.runs));
      for (const int arrows : arrowCounts) {
        if (Status added = add(cpuStep(setup, cells, arrows, sweep.median)); !added) return added.error();
      }
    }
    if (setup.context != nullptr) {
      if (Status added = add(gpuPlainStep(setup, cells)); !added) return added.error();
      for (const int arrows : arrowCounts) {
        if (Status added = add(gpuStep(setup, cells, arrows)); !added) return added.error();
      }
    }
  }
  return rows;
}

}  // namespace windloom::cli
