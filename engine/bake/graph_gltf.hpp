#pragma once
// The arrow graph as a glTF scene, so that other tools can place things along the drawn wind.

#include <filesystem>

#include "engine/bake/frame_writer.hpp"
#include "engine/model/project.hpp"

namespace windloom {

/// The text: one node a tree, "AGC_" and the name or id of its root, at the root's place on the ground; below it a node
/// an arrow, at its start, whose +Z points along it, with the arrow's settings in `extras`; and a mesh of lines a tree,
/// so that any viewer shows it. An arrow belongs to the tree of the root that reaches it first. glTF's frame
/// (right-handed, +Y up, metres) is ours. The scene's `extras.wind` names the files of the bake. Legal glTF 2.0: no
/// extension is used.
std::string graphGltfText(const Project& project, const BakeHeader& header, std::span<const BakedFile> files);

/// Writes it as "graph.gltf" into `folder`. Fails with Machine.
Result<BakedFile> writeGraphGltf(const Project& project, const BakeHeader& header, std::span<const BakedFile> files,
                                 const std::filesystem::path& folder);

}  // namespace windloom
