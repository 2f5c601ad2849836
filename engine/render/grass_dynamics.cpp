#include "engine/render/grass_dynamics.hpp"

#include <algorithm>

#include "engine/model/collider_motion.hpp"

namespace windloom {
namespace {

/// m: of all blades, by their settings.
float tallestOf(const Project& project) {
  float tallest = project.grass->height * (1.0f + project.grass->heightVariation);
  for (const Species& kind : *project.species) {
    if (!kind.hidden) tallest = std::max(tallest, kind.height * (1.0f + kind.heightVariation));
  }
  return tallest;
}

}  // namespace

Result<GrassDynamics> GrassDynamics::create(gpu::ShaderLibrary& shaders) {
  Result<VirtualBlades> blades = VirtualBlades::create(shaders);
  if (!blades) return blades.error();
  Result<GrassPatches> patches = GrassPatches::create(shaders);
  if (!patches) return patches.error();
  return GrassDynamics(std::move(*blades), std::move(*patches));
}

Status GrassDynamics::configure(const Project& project, const GrassLayout& layout) {
  m_touchClock.forget();
  m_cells = glm::ivec2(-1);
  return m_patches.configure(*project.grass, layout, tallestOf(project));
}

Status GrassDynamics::fitWind(const GrassSettings& grass, glm::ivec2 cells, int mostBlades) {
  if (cells == m_cells) return Done{};
  if (Status set = m_blades.configure(grass, cells, mostBlades); !set) return set;
  m_cells = cells;
  return Done{};
}

void GrassDynamics::touch(const Project& project, const TouchSteps& steps) {
  const HeightField* ground = project.terrain->heights.get();
  if (steps.fromRest) m_patches.step({0.0f, true}, {}, ground);
  for (int i = 1; i <= steps.count; ++i) {
    const double at = steps.start + i * double(steps.seconds);
    m_patches.step({steps.seconds, false}, colliderPrimitives(project, at), ground);
  }
}

void GrassDynamics::advance(const Project& project, double seconds, RunUp runUp) {
  const DynamicsStep swing = m_bladeClock.advance(seconds);
  if (project.grass->deformation == Deformation::Inertial) m_blades.step(swing);
  m_blades.bind();
  // While time stands, an edited collider shows at once what it would have done; while it runs, it just goes on.
  if (project.colliders != m_colliders && m_touchClock.standsAt(seconds)) m_touchClock.forget();
  m_colliders = project.colliders;
  const TouchSteps steps = m_touchClock.advance(seconds, double(project.field->timeStep), runUp);
  // Without colliders nothing is touched; what was touched before they went rises on.
  if (steps.count == 0 || (project.colliders->empty() && m_patches.cells().patches().empty())) return;
  touch(project, steps);
}

void GrassDynamics::bind() const {
  m_blades.bind();
  m_patches.bind();
}

}  // namespace windloom
