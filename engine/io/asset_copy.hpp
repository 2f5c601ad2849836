#pragma once
// Files that a project uses (its terrain, plants, colliders, surfaces, maps) belong to its folder: what lies elsewhere
// is copied there, and goes along when the project is saved into another folder. A different file is never written
// over.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/io/file_access.hpp"
#include "engine/model/project.hpp"

namespace windloom {

/// The files that a project names, each once, in the order of the project file: terrain, grass maps, species,
/// colliders, surfaces.
std::vector<std::string> assetFiles(const Project& project);

/// The files that a file needs, relative to its folder: the buffers and pictures of a .gltf. Fails with BadInput where
/// it can't be read, is over a limit of glTF files or refers to files outside its folder, by a link that `access`
/// doesn't allow or by a web address, naming them.
Result<std::vector<std::string>> assetCompanions(const std::filesystem::path& file, const FileAccess& access = {});

/// The path of `file` as a project names it. A file outside the project's folder is copied to `assets/` in it, under a
/// number where another file has the name; a .gltf with companions gets a folder of its own there. Fails with BadInput
/// as assetCompanions, where a companion is missing or where a link in the project's folder would lead a copy out of
/// it, with Machine where copying does.
Result<std::string> bringAsset(const std::filesystem::path& file, const std::filesystem::path& projectFolder);

/// Copies files of a project (names as assetFiles gives them) and their companions to the same places below another
/// folder. Files missing at the source are left out, and so are those whose names leave the folder, which stay where
/// they are, and links that lead out of it where that is not allowed. Fails with BadInput where a different file is
/// there or a link in the other folder leads out of it, before anything is copied, with Machine where copying does.
Status copyAssetsAlong(const std::vector<std::string>& files, const std::filesystem::path& fromFolder,
                       const std::filesystem::path& toFolder, OutsideFiles outside = OutsideFiles::Refuse);

}  // namespace windloom
