#pragma once
// Reading a plant, an object or a map over the field beside the frame loop, and bringing it into the project's folder.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "editor/core/background_read.hpp"
#include "engine/core/result.hpp"
#include "engine/model/edit.hpp"

namespace windloom::editor {

/// What a file is for.
enum class AssetPlace { SpeciesMesh, ColliderMesh, DensityMap, HeightMap, ColourMap };
struct AssetTarget {
  AssetPlace place = AssetPlace::SpeciesMesh;
  Id id = 0;  ///< of the species or collider
  bool operator==(const AssetTarget&) const = default;
};

struct LoadedAsset {
  AssetTarget target;
  std::variant<std::shared_ptr<const PlantMesh>, std::shared_ptr<const GrassMap>> value;  ///< with its file's name
};

class AssetLoad {
 public:
  /// Begins to read `file` for the project at `projectFile`; what was being read is given up.
  void start(AssetTarget target, std::filesystem::path file, std::filesystem::path projectFile);
  /// What is being read; nothing where nothing runs.
  [[nodiscard]] std::optional<AssetTarget> target() const;
  /// "Reading fern.glb"; empty where nothing runs.
  [[nodiscard]] std::string doing() const { return m_read.doing(); }
  /// Nothing comes of it any more.
  void cancel() { m_read.cancel(); }
  /// The mesh or map, once, when it is there. Fails as readPlantFile, readGrassMap and bringAsset.
  std::optional<Result<LoadedAsset>> poll() { return m_read.poll(); }

 private:
  AssetTarget m_target;
  BackgroundRead<LoadedAsset> m_read;
};

/// Puts what was read in its place, as one step: the species or collider becomes a mesh. Fails with BadInput where the
/// species or collider is gone.
Result<Edit> assetEdit(const Project& project, const LoadedAsset& asset);

/// The name of its file, as the project names it.
const std::string& fileOf(const LoadedAsset& asset);

}  // namespace windloom::editor
