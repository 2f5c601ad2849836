#pragma once
// Reading the files of species, colliders, surfaces and pictures of the grass beside the frame loop, and bringing them
// into the project's folder.

#include <filesystem>
#include <memory>
#include <vector>

#include "editor/core/file_load.hpp"
#include "editor/core/object_edits.hpp"
#include "engine/model/edit.hpp"

namespace windloom::editor {

enum class AssetUse { Species, Collider, Surface, DensityMap, HeightMap, ColourMap, ShellPicture };
/// Whether it is a picture of the project's grass, which can be taken out again; else a mesh.
bool isPicture(AssetUse use);

/// What a file is for.
struct AssetTarget {
  AssetUse use = AssetUse::Species;
  std::vector<Id> ids = {};  ///< the records that get it; none: a new one
  glm::vec2 place{0.0f};     ///< m: of a new collider or surface
};
/// The endings that such a file may have, as FileBrowser wants them: ".glb;.gltf".
const char* assetEndings(AssetUse use);

/// One of the two.
struct LoadedAsset {
  AssetTarget target;
  std::shared_ptr<const PlantMesh> mesh;
  std::shared_ptr<const GrassMap> picture;

  [[nodiscard]] const std::string& file() const { return mesh ? mesh->file : picture->file; }
};

class AssetLoad : public FileLoad<LoadedAsset> {
 public:
  /// Begins to read `file` for the project at `projectFile`; what was being read is given up. poll() gives it with its
  /// name below the project's folder, and fails as readPlantFile, readGrassMap, readShellPicture and
  /// bringAsset.
  void start(AssetTarget target, const std::filesystem::path& file, const std::filesystem::path& projectFile);
};

/// Gives the file to its target, as one step. No steps where the records are gone; `id` is that of a new record, else
/// 0.
AddResult assetEdit(const Project& project, const LoadedAsset& asset);
/// The picture's name and pixels taken out.
Edit clearPictureEdit(const Project& project, AssetUse picture);
/// The file's name as the project has it; of records the first one's. Empty where there is none.
std::string assetFileOf(const Project& project, const AssetTarget& target);
/// Whether what the file holds is there; true where no file is named.
bool isAssetRead(const Project& project, const AssetTarget& target);

}  // namespace windloom::editor
