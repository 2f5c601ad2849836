#pragma once
// Plants, tufts, things that move through the grass and things that it grows on, from glTF 2.0 files (.glb, .gltf).
//
// All triangles of the default scene count, placed by their nodes; y is up, the origin is the root. Normals that are
// missing are made. Colour is the base colour factor times COLOR_0 times the base colour texture (PNG or JPEG); several
// textures are packed into one, and then can't repeat. Alpha is tested, not blended. Not read: skins, morphs,
// animation, points and lines.

#include <filesystem>
#include <memory>

#include "engine/core/result.hpp"
#include "engine/io/file_access.hpp"
#include "engine/model/plant_mesh.hpp"

namespace windloom {

inline constexpr std::size_t kMaxSurfaceTriangles = 2'000'000;  ///< of one surface

enum class MeshUse {
  Plant,    ///< at most kMaxPlantTriangles; must rise over its root
  Object,   ///< at most kMaxObjectTriangles; gets spheres
  Surface,  ///< at most kMaxSurfaceTriangles; must have an area; without colours and textures
};

/// `file` of the mesh stays empty; `access` is for the files that it needs. Fails with BadInput, the file named, where
/// it is missing, damaged, empty or over a limit, with Machine where there is not enough memory.
Result<std::shared_ptr<PlantMesh>> readPlantFile(const std::filesystem::path& file, MeshUse use,
                                                 const FileAccess& access = {});

}  // namespace windloom
