#pragma once
// manifest.json: what a game or a person needs to know to use the files beside it. docs/bake.md describes each key.

#include <filesystem>
#include <span>
#include <string>

#include "engine/bake/frame_writer.hpp"
#include "engine/model/project.hpp"

namespace windloom {

struct ManifestFile {
  BakedFile file;
  std::string sha256;
};

/// The text. `backend` is the one that ran.
std::string manifestText(const BakeHeader& header, const Project& project, Backend backend,
                         std::span<const ManifestFile> files);

/// The names of the files that the manifest in `folder` lists; empty where there is none or it isn't ours. Only plain
/// names, never paths.
std::vector<std::string> filesOfManifest(const std::filesystem::path& folder);

}  // namespace windloom
