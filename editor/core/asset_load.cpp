#include "editor/core/asset_load.hpp"

#include <algorithm>

#include "engine/io/asset_copy.hpp"
#include "engine/io/assets.hpp"
#include "engine/io/plant_file.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;
namespace {

using Watch = BackgroundRead<LoadedAsset>::Watch;

/// Brings a file that was read into the project and names it so.
template <class T>
Result<LoadedAsset> bring(AssetTarget target, Result<std::shared_ptr<T>> read, const fs::path& file,
                          const fs::path& projectFile, const Watch& watch) {
  if (!read) return read.error();
  // Copied only when it is known to be good.
  if (!watch("Bringing it into the project's folder")) return makeError(ErrorKind::Usage, "stopped");
  std::error_code ignored;
  Result<std::string> name = bringAsset(file, fs::absolute(projectFile, ignored).parent_path());
  if (!name) return name.error();
  const std::shared_ptr<T> made = *read;
  WL_REQUIRE(made != nullptr, "a file that was read has contents");
  made->file = *name;
  return LoadedAsset{target, std::shared_ptr<const T>(made)};
}

Result<LoadedAsset> load(AssetTarget target, const fs::path& file, const fs::path& projectFile, const Watch& watch) {
  if (target.place == AssetPlace::SpeciesMesh)
    return bring(target, readPlantFile(file, MeshUse::Plant), file, projectFile, watch);
  if (target.place == AssetPlace::ColliderMesh)
    return bring(target, readPlantFile(file, MeshUse::Object), file, projectFile, watch);
  return bring(target, readGrassMap(file), file, projectFile, watch);
}

template <class Record, class Shape>
Result<Edit> meshEdit(const std::vector<Record>& records, const LoadedAsset& asset, Shape mesh, const char* label) {
  const auto found = std::ranges::find(records, asset.target.id, &Record::id);
  if (found == records.end()) {
    return makeError(ErrorKind::BadInput, "What " + fileOf(asset) + " was read for has been deleted meanwhile");
  }
  Record record = *found;
  record.shape = mesh;
  record.file = fileOf(asset);
  record.mesh = std::get<std::shared_ptr<const PlantMesh>>(asset.value);
  return Edit{.label = label, .steps = {Put<Record>{std::move(record)}}, .mergeKey = {}};
}

}  // namespace

void AssetLoad::start(AssetTarget target, fs::path file, fs::path projectFile) {
  m_target = target;
  std::string doing = "Reading " + file.filename().string(), name = file.string();
  m_read.start(std::move(doing), std::move(name),
               [target, file = std::move(file), projectFile = std::move(projectFile)](const Watch& watch) {
                 return load(target, file, projectFile, watch);
               });
}

std::optional<AssetTarget> AssetLoad::target() const {
  if (!m_read.running()) return std::nullopt;
  return m_target;
}

const std::string& fileOf(const LoadedAsset& asset) {
  return std::visit([](const auto& value) -> const std::string& { return value->file; }, asset.value);
}

Result<Edit> assetEdit(const Project& project, const LoadedAsset& asset) {
  if (asset.target.place == AssetPlace::SpeciesMesh)
    return meshEdit(*project.species, asset, PlantShape::Mesh, "Set plant");
  if (asset.target.place == AssetPlace::ColliderMesh)
    return meshEdit(*project.colliders, asset, ColliderShape::Mesh, "Set object");
  GrassSettings grass = *project.grass;
  const auto& map = std::get<std::shared_ptr<const GrassMap>>(asset.value);
  switch (asset.target.place) {
    case AssetPlace::DensityMap:
      grass.densityMap = map->file;
      grass.densityPixels = map;
      break;
    case AssetPlace::HeightMap:
      grass.heightMap = map->file;
      grass.heightPixels = map;
      break;
    default:
      grass.colourMap = map->file;
      grass.colourPixels = map;
      break;
  }
  return Edit{.label = "Set map", .steps = {Set<GrassSettings>{std::move(grass)}}, .mergeKey = {}};
}

}  // namespace windloom::editor
