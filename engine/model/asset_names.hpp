#pragma once
// Names of the files that a project uses (terrain, maps, species, colliders, surfaces), as they stand in it: paths from
// the project's folder. Those that leave it are kept, but read only where the user allows it
// (engine/io/file_access.hpp).

#include <string>
#include <string_view>
#include <vector>

#include "engine/model/project.hpp"

namespace windloom {

/// Where a name is no path that a project can hold: what was expected. Empty where it is legal or empty.
std::string assetFileProblem(std::string_view file);

/// Where a legal name leaves the project's folder: "an absolute path", or "which leaves the project's folder". Empty
/// where it stays below, links in the folder not counted.
std::string_view outsideReason(std::string_view file);

struct AssetName {
  std::string pointer;  ///< its place in the project file
  std::string file;     ///< never empty
};
/// All of a project, in the order of the project file; a file that is used twice is there twice.
std::vector<AssetName> assetNames(const Project& project);

}  // namespace windloom
