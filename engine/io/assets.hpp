#pragma once
// The files that a project's meadow and colliders are made of: meshes of species, colliders and surfaces, maps over the
// field.

#include <filesystem>
#include <memory>

#include "engine/core/result.hpp"
#include "engine/io/file_access.hpp"
#include "engine/model/project.hpp"

namespace windloom {

inline constexpr std::size_t kMaxProjectTriangles = 20'000'000;  ///< of all meshes of a project, each file once

/// A PNG picture (8 or 16 bit) for GrassSettings: black and white, or colours. One larger than kMaxGrassMap a side is
/// made smaller by averaging. `file` of the map stays empty. Fails with BadInput, the file named, where it is missing,
/// damaged or no PNG.
Result<std::shared_ptr<GrassMap>> readGrassMap(const std::filesystem::path& file);

/// The same for ShellSettings::texture: blades seen from above, their height in alpha. Fails as well where alpha is 0
/// everywhere (no blade) or nowhere below 1 (nothing would be cut out, as with a picture that has no alpha at all).
Result<std::shared_ptr<GrassMap>> readShellPicture(const std::filesystem::path& file);

/// Fills in Species::mesh, Collider::mesh, Surface::mesh and the pixels of GrassSettings and ShellSettings of a project
/// of this file.
/// What is loaded already under the same name is shared, not read again. Fails with BadInput, one problem for each file
/// that couldn't be read, or that has more triangles than kMaxProjectTriangles leaves, at its place
/// ("/species/2/file"); that mesh or map then stays as it was and all others are filled in.
Status loadAssets(Project& project, const std::filesystem::path& projectFile,
                  OutsideFiles outside = OutsideFiles::Refuse);

}  // namespace windloom
