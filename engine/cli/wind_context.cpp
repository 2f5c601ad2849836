#include "engine/cli/wind_context.hpp"

#include "engine/cli/option_checks.hpp"
#include "engine/cli/option_limits.hpp"
#include "engine/cli/program_help.hpp"
#include "engine/session/solver_scheme.hpp"

namespace windloom::cli {

const char* backendName(Backend backend) {
  return backend == Backend::Gpu ? "gpu" : "cpu";
}

namespace {

std::string solverNames() {
  std::string names;
  for (const SolverPreset& preset : solverPresets()) names.append(names.empty() ? "" : ", ").append(preset.name);
  return names;
}

}  // namespace

void addSolverOption(CLI::App& app, std::string& name) {
  std::vector<std::string> names;
  for (const SolverPreset& preset : solverPresets()) names.emplace_back(preset.name);
  offer(app.add_option("--solver", name, "Solver preset instead of the project's settings: " + solverNames())
            ->type_name("NAME"),
        names);
}

void addRunOptions(CLI::App& app, RunOptions& options) {
  auto* initial = app.add_option("--initial", options.initial,
                                 "Start from this wind instead: .npy, float32 [height, width, 2] in m/s, or an earlier "
                                 "bake's last frame")
                      ->type_name("FILE.npy");
  app.add_option("--initial-time", options.initialTime,
                 "Moment that --initial holds, s: arrows and gusts go on from there (default 0)")
      ->type_name("S")
      ->check(numberFrom(0.0, kMaxSeconds))
      ->needs(initial);
  addSolverOption(app, options.solver);
  app.add_option("--threads", options.threads, "Threads of the CPU backend (default: all; results are the same)")
      ->type_name("N")
      ->transform(wholeFrom(1, 256));
}

Status useSolver(Project& project, const std::string& name) {
  if (name.empty()) return Done{};
  for (const SolverPreset& preset : solverPresets()) {
    if (preset.name != name) continue;
    project.solver = std::make_shared<SolverSettings>(withScheme(*project.solver, preset));
    return Done{};
  }
  return makeError(ErrorKind::Usage, "--solver: found '" + name + "', expected one of " + solverNames());
}

Json diagnosticsJson(const WindDiagnostics& d) {
  Json json = {{"step", d.step},
               {"divergenceBefore", d.divergenceBefore},
               {"divergenceAfter", d.divergenceAfter},
               {"maxDivergenceBefore", d.maxDivergenceBefore},
               {"maxDivergenceAfter", d.maxDivergenceAfter},
               {"residual", d.divergenceBefore > 0 ? d.divergenceAfter / d.divergenceBefore : 0.0},
               {"kineticEnergy", d.kineticEnergy},
               {"maxSpeed", d.maxSpeed},
               {"cfl", d.cfl},
               {"cycles", d.cycles},
               {"nonFiniteCells", d.nonFiniteCells},
               {"stepMs", d.stepMs},
               {"stageMs", Json::object()}};
  if (d.nonFiniteCells > 0) json["firstNonFinite"] = {d.firstNonFinite.x, d.firstNonFinite.y};
  for (const auto& [stage, ms] : d.stageMs) json["stageMs"][stage] = ms;
  return json;
}

}  // namespace windloom::cli
