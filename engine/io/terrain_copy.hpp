#pragma once
// Terrain files belong to the project's folder: what lies elsewhere is copied there, and goes along when the project
// is saved into another folder. A different file is never written over.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/result.hpp"

namespace windloom {

/// The files that a terrain file needs, relative to its folder: the buffers and pictures of a .gltf. Fails with
/// BadInput where it can't be read or refers to files outside its folder or by a web address, naming them.
Result<std::vector<std::string>> terrainCompanions(const std::filesystem::path& file);

/// The path of `file` as TerrainSettings::file wants it. A file outside the project's folder is copied to `assets/` in
/// it, under a number where another file has the name; a .gltf with companions gets a folder of its own there. Fails
/// with BadInput as terrainCompanions or where a companion is missing, with Machine where copying does.
Result<std::string> bringTerrainFile(const std::filesystem::path& file, const std::filesystem::path& projectFolder);

/// Copies a project's terrain file and its companions to the same place below another folder. A file missing at the
/// source is left out. Fails with BadInput where a different file is there, with Machine where copying does.
Status copyTerrainAlong(const std::string& file, const std::filesystem::path& fromFolder,
                        const std::filesystem::path& toFolder);

}  // namespace windloom
