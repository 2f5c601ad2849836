#pragma once
// The pictures of a plant's materials, packed into one. Inside engine/io only.

#include "engine/io/gltf_file.hpp"
#include "engine/model/plant_mesh.hpp"

namespace windloom::gltf {

/// A material as the triangles that use it need it.
struct PlantMaterial {
  glm::vec4 colour{1.0f};           ///< linear, times texture and vertex
  int texCoord = -1;                ///< set of coordinates; -1: no texture
  glm::mat3 transform{1.0f};        ///< of those coordinates (KHR_texture_transform)
  glm::vec2 low{0.0f}, size{1.0f};  ///< of its picture in the common one, 0..1
  bool alone = true;                ///< its picture is the whole: coordinates outside 0..1 repeat it
};

/// Makes mesh.texture, textureSize and alphaCutoff from the materials that `used` names (-1: none given), and says how
/// each is used, in the order of `used`. Several pictures are stacked, so that they can't repeat. Fails with BadInput
/// where a picture is missing, damaged or no PNG or JPEG, or where a limit above is passed.
Result<std::vector<PlantMaterial>> packMaterials(const tinygltf::Model& model, const std::vector<int>& used,
                                                 const std::filesystem::path& file, PlantMesh& mesh);

}  // namespace windloom::gltf
