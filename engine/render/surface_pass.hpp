#pragma once
// Surfaces that grass grows on: their bare meshes, which the grass stands on and which hide what is behind them.

#include <vector>

#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/model/project.hpp"
#include "engine/render/object_mesh.hpp"

namespace windloom {

class SurfacePass {
 public:
  /// Fails with Machine.
  static Result<SurfacePass> create(gpu::ShaderLibrary& shaders);

  /// Takes over the surfaces that aren't hidden and have been read; meshes that it has already cost nothing. `ground`
  /// may be null: flat at 0. Fails with Machine.
  Status configure(const std::vector<Surface>& surfaces, const HeightField* ground);

  /// Both sides of all of them. The frame block, noise, ground, map of solids and the colliders' shades must be bound.
  void draw(const gpu::PassState& state) const;
  /// Calls `draw(surface, world, mesh)` for each that is shown.
  template <class Draw>
  void each(Draw draw) const {
    for (const Shown& shown : m_shown) {
      if (const ObjectMesh* mesh = m_meshes.find(shown.mesh)) draw(shown.surface, shown.world, *mesh);
    }
  }
  /// Spheres that stand for them where they take light from what is around (makeColliderShades), m.
  [[nodiscard]] const std::vector<glm::vec4>& shades() const { return m_shades; }
  [[nodiscard]] bool any() const { return !m_shown.empty(); }

 private:
  struct Shown {
    Surface surface;
    std::shared_ptr<const PlantMesh> mesh;
    glm::mat4 world;
  };
  SurfacePass() = default;

  gpu::Program* m_program = nullptr;
  ObjectMeshes m_meshes;
  std::vector<Shown> m_shown;
  std::vector<glm::vec4> m_shades;
};

}  // namespace windloom
