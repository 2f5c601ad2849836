#pragma once
// Grass that remembers: the virtual blades of the inertial model and the patches that colliders touch, led to the time
// of a frame.

#include "engine/grass/grass_patches.hpp"
#include "engine/grass/touch_clock.hpp"
#include "engine/grass/virtual_blades.hpp"
#include "engine/model/project.hpp"

namespace windloom {

class GrassDynamics {
 public:
  /// Fails with Machine.
  static Result<GrassDynamics> create(gpu::ShaderLibrary& shaders);

  /// Takes over the meadow; what grass remembers of another one is dropped. Fails with Machine.
  Status configure(const Project& project, const GrassLayout& layout);
  /// Takes over the wind's grid, for at most so many virtual blades a side; costs nothing while it stays the same.
  /// Fails with Machine.
  Status fitWind(const GrassSettings& grass, glm::ivec2 cells, int mostBlades);

  /// To `seconds` of simulated time. A jump in time begins anew: inertial grass at rest in the present wind, touched
  /// grass by what the colliders did shortly before. All that InstancedGrass::prepare needs must be bound.
  void advance(const Project& project, double seconds, RunUp runUp);

  /// Whether anything is still bent by what touched it.
  [[nodiscard]] bool touched() const { return !m_patches.cells().patches().empty(); }

  /// For the passes that place blades.
  void bind() const;

 private:
  GrassDynamics(VirtualBlades blades, GrassPatches patches)
      : m_blades(std::move(blades)), m_patches(std::move(patches)) {}
  void touch(const Project& project, const TouchSteps& steps);

  VirtualBlades m_blades;
  GrassPatches m_patches;
  DynamicsClock m_bladeClock;
  TouchClock m_touchClock;
  Shared<std::vector<Collider>> m_colliders;  // of the last frame
  glm::ivec2 m_cells{-1};
};

}  // namespace windloom
