#pragma once
// Reading a terrain file beside the frame loop, and bringing it into the project's folder.

#include <filesystem>
#include <memory>

#include "editor/core/file_load.hpp"
#include "engine/model/edit.hpp"

namespace windloom::editor {

class TerrainLoad : public FileLoad<std::shared_ptr<const HeightSource>> {
 public:
  /// Begins to read `file` for the project at `projectFile`; what was being read is given up. poll() gives the source
  /// with its file's name, and fails as readTerrainFile and bringAsset; after cancel() nothing is copied.
  void start(const std::filesystem::path& file, const std::filesystem::path& projectFile);
};

/// Makes a source the project's ground, as one step. A first height map covers the wind field; one that takes the place
/// of another keeps its place and height.
Edit terrainEdit(const Project& project, std::shared_ptr<const HeightSource> source);

}  // namespace windloom::editor
