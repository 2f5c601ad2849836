#pragma once
// What the readers of glTF files share: the parsed file, its meshes as the scene places them, checked looks into its
// buffers. Inside engine/io only.

#include <tiny_gltf.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/io/file_access.hpp"
#include "engine/io/gltf_limits.hpp"

namespace windloom::gltf {

/// BadInput with the file's name.
Error refuse(const std::filesystem::path& file, std::string message);

enum class Pictures {
  Leave,  ///< not even opened
  Keep,   ///< Image::image holds the file's bytes as they are (PNG, JPEG); empty where the file is missing
};

/// A .glb or .gltf with its buffers. Other files are opened only below its own folder, by names without "..", and where
/// `access` lets them be, or anywhere on this machine where it allows that; nothing is ever fetched. Fails with
/// BadInput where it is missing, damaged, over a limit or needs an extension that can't be read.
Result<tinygltf::Model> parse(const std::filesystem::path& file, Pictures pictures, const FileAccess& access = {});

/// A mesh where the default scene (or, without scenes, every node) puts it. `mesh` is a valid index.
struct PlacedMesh {
  std::size_t mesh = 0;
  glm::dmat4 world{1.0};
};
/// Fails with BadInput where a node or mesh isn't there, and where more than kMaxPlacedPrimitives would be placed.
Result<std::vector<PlacedMesh>> meshesOfScene(const tinygltf::Model& model, const std::filesystem::path& file);

/// Its mode is triangles.
bool isTriangles(const tinygltf::Primitive& primitive);

/// The bytes of an accessor: `count` elements, `stride` bytes apart, each as long as was asked for.
struct Elements {
  const unsigned char* bytes = nullptr;
  std::size_t count = 0, stride = 0;
};
/// Fails with BadInput where the accessor doesn't exist, reaches beyond its buffer or has more than `most` elements.
Result<Elements> elementsOf(const tinygltf::Model& model, int accessor, std::size_t elementBytes, std::size_t most,
                            const std::filesystem::path& file);

/// Appends the indices of a primitive's whole triangles, each plus `first`; all are below `vertices`. Without an
/// accessor (-1): 0, 1, 2 and so on. Fails with BadInput where `into` would get longer than `most`.
Status appendIndices(const tinygltf::Model& model, int accessor, std::size_t first, std::size_t vertices,
                     std::size_t most, const std::filesystem::path& file, std::vector<std::uint32_t>& into);

/// Appends the positions of a primitive, placed. Fails with BadInput where one is not finite, or `into` would get
/// longer than `most`.
Status appendPositions(const tinygltf::Model& model, int accessor, const glm::dmat4& world, std::size_t most,
                       const std::filesystem::path& file, std::vector<glm::vec3>& into);

}  // namespace windloom::gltf
