#include "engine/session/solver_scheme.hpp"

#include "engine/model/parameters.hpp"

namespace windloom {

SolverSettings withScheme(const SolverSettings& current, const SolverPreset& preset) {
  SolverSettings settings = preset.settings;
  settings.backend = current.backend;
  settings.maxSpeed = current.maxSpeed;
  settings.seed = current.seed;
  settings.extra = current.extra;
  return settings;
}

bool hasScheme(const SolverSettings& current, const SolverPreset& preset) {
  const SolverSettings wanted = withScheme(current, preset);
  for (const Parameter<SolverSettings>& parameter : parametersOf<SolverSettings>()) {
    if (parameter.get(current) != parameter.get(wanted)) return false;
  }
  return true;
}

}  // namespace windloom
