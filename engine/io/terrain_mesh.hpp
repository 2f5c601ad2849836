#pragma once
// The triangles of a glTF file, and a grid of heights from triangles.

#include "engine/io/terrain_file.hpp"

namespace windloom {

struct TriangleMesh {
  std::vector<glm::vec3> vertices;     ///< m, +y up
  std::vector<std::uint32_t> indices;  ///< three a triangle, all below vertices.size()
};

/// Fails as readTerrainFile does.
Result<TriangleMesh> readMesh(const std::filesystem::path& file, const LoadWatch& watch = {},
                              const FileAccess& access = {});

/// The mesh seen from above, see terrain_file.hpp. Fails with BadInput (`file` goes into the message) where it covers
/// no ground or its triangles lie over each other so often that kMaxDrawnSamples don't do, and with Usage where `watch`
/// stopped it.
Result<std::shared_ptr<HeightSource>> heightsOfMesh(const TriangleMesh& mesh, const std::filesystem::path& file,
                                                    const LoadWatch& watch = {});

}  // namespace windloom
