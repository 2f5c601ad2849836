#include "engine/session/wind_context.hpp"

namespace windloom {

Result<WindContext> openWindContext(Backend asked, const Project& project) {
  WindContext wind;
  const Backend wanted = asked != Backend::Auto ? asked : project.solver->backend;
  if (wanted == Backend::Cpu) return wind;
  Result<std::unique_ptr<gpu::Context>> context = gpu::createOffscreenContext();
  if (!context) {
    if (wanted == Backend::Gpu) return context.error();
    return wind;
  }
  if (wanted == Backend::Auto && (*context)->info().software) return wind;
  Result<std::unique_ptr<gpu::ShaderLibrary>> shaders = gpu::ShaderLibrary::create();
  if (!shaders) {
    if (wanted == Backend::Gpu) return shaders.error();
    return wind;
  }
  wind.context = std::move(*context);
  wind.shaders = std::move(*shaders);
  return wind;
}

Result<std::unique_ptr<Simulation>> makeSimulation(const Project& project, Backend asked, const WindContext& wind,
                                                   int threads) {
  SimulationOptions options;
  options.backend = asked;
  options.context = wind.context.get();
  options.shaders = wind.shaders.get();
  options.threads = threads;
  return Simulation::create(project, options);
}

}  // namespace windloom
