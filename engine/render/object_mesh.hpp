#pragma once
// Triangle meshes on the GPU, as colliders and surfaces draw them.

#include <memory>
#include <span>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/gpu/buffer.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "engine/model/plant_mesh.hpp"

namespace windloom {

struct ObjectMesh {
  std::shared_ptr<const PlantMesh> mesh;
  gpu::Buffer vertices, indices;
  gpu::VertexArray array;  ///< positions 0, normals 1, texture coordinates 2, colours 3
  gpu::Texture texture;    ///< none where the mesh has none

  /// All triangles, so many times, with the program and state that are bound.
  void draw(int instances = 1) const;
};

class ObjectMeshes {
 public:
  /// Takes over these; those that it has already cost nothing. Null ones and those without triangles are left out.
  /// Fails with Machine; then it has fewer of the old ones.
  Status configure(std::span<const std::shared_ptr<const PlantMesh>> meshes);

  /// Null where it doesn't have it.
  [[nodiscard]] const ObjectMesh* find(const std::shared_ptr<const PlantMesh>& mesh) const;

 private:
  std::vector<ObjectMesh> m_meshes;
};

}  // namespace windloom
