#pragma once
// Colliders: drawn as a ball, a shoe or their mesh, and the light that they take from what is around them
// (shaders/include/colliders.glsl).

#include <span>
#include <vector>

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "engine/model/project.hpp"
#include "engine/render/object_mesh.hpp"
#include "shaders/shared/collider_shade.h"

namespace windloom {

using shared::ColliderShadeBlock;

/// The spheres that stand for the colliders that are shown at a time: the nearest to `eye` where there are too many,
/// and the largest of a mesh. After them, where there is room, those of `surfaces` (SurfacePass::shades).
/// `sunDirection` is a unit vector towards the sun.
ColliderShadeBlock makeColliderShades(const Project& project, double seconds, glm::vec3 eye, glm::vec3 sunDirection,
                                      std::span<const glm::vec4> surfaces = {});

class ColliderPass {
 public:
  /// Fails with Machine.
  static Result<ColliderPass> create(gpu::ShaderLibrary& shaders);

  /// Takes over the meshes; those that it has already cost nothing. Fails with Machine.
  Status configure(const std::vector<Collider>& colliders);

  /// Binds the light they take at a time, for every shader that asks for it.
  void bindShades(const Project& project, double seconds, glm::vec3 eye, glm::vec3 sunDirection,
                  std::span<const glm::vec4> surfaces);
  /// Draws those that aren't hidden, `project` having been configured.
  void draw(const gpu::PassState& state, const Project& project, double seconds) const;

 private:
  ColliderPass() = default;
  void drawShape(const Collider& collider, const glm::mat4& world) const;
  void drawMesh(const Collider& collider, const glm::mat4& world) const;

  gpu::Program* m_drawShape = nullptr;
  gpu::Program* m_drawMesh = nullptr;
  ObjectMeshes m_objects;
  gpu::Texture m_white;  // of meshes without a texture
  gpu::Buffer m_shades;
  gpu::VertexArray m_noVertices;
};

}  // namespace windloom
