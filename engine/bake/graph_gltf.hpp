#pragma once
// The arrow graph as a glTF scene, so that other tools can place things along the drawn wind.

#include <filesystem>

#include "engine/bake/frame_writer.hpp"
#include "engine/model/project.hpp"

namespace windloom {

/// Writes "graph.gltf" into `folder`, in glTF's frame (right-handed, +Y up, metres, which is ours): one node a tree
/// named after its root, a child node an arrow with the arrow's settings in `extras`, and a mesh of lines so that any
/// viewer shows it. The scene's `extras.wind` names the files of the bake. Always legal glTF 2.0: no extension is used.
/// Fails with Machine.
Result<BakedFile> writeGraphGltf(const Project& project, const BakeHeader& header, std::span<const BakedFile> files,
                                 const std::filesystem::path& folder);

}  // namespace windloom
