#pragma once
// Which files a project may have read. A project comes from anywhere, by mail or from the web: what it names is read
// only where it lies below the project's own folder, links followed to where they lead. The user may allow more.

#include <filesystem>
#include <string>

#include "engine/core/result.hpp"
#include "engine/model/project.hpp"

namespace windloom {

enum class OutsideFiles {
  Refuse,
  Allow,  ///< the user said so, for this project's folder
};

/// What a file and the files that it needs may reach.
struct FileAccess {
  std::filesystem::path folder;  ///< all must lie below it, links followed; empty: below the file's own folder
  OutsideFiles outside = OutsideFiles::Refuse;
};

/// That of a project: its own folder and what lies below.
FileAccess accessOf(const std::filesystem::path& projectFile, OutsideFiles outside);

/// True where `path`, links followed, lies below `folder`, links followed. Either may be relative to the working
/// folder.
bool liesBelow(const std::filesystem::path& path, const std::filesystem::path& folder);

/// True where `path` may be read.
bool mayRead(const FileAccess& access, const std::filesystem::path& path);

/// The path of a file as a project names it. Fails with BadInput, without looking into the file, where it leaves the
/// project's folder by its name or through a link and that is not allowed.
Result<std::filesystem::path> findAsset(const std::filesystem::path& projectFile, const std::string& name,
                                        OutsideFiles outside);

/// True where a project of this file names a file that findAsset refuses.
bool namesFilesOutside(const Project& project, const std::filesystem::path& projectFile);

}  // namespace windloom
