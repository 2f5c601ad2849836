#include "editor/core/terrain_load.hpp"

#include "engine/io/asset_copy.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;
namespace {

Result<std::shared_ptr<const HeightSource>> load(const fs::path& file, const fs::path& projectFile,
                                                 const LoadWatch& watch) {
  const auto kind = terrainKindOf(file);
  if (!kind) {
    return makeError(ErrorKind::BadInput, file.string(), {}, "is no terrain, expected .png, .glb or .gltf");
  }
  Result<std::shared_ptr<HeightSource>> source = readTerrainFile(file, *kind, watch);
  if (!source) return source.error();
  // Copied only when it is known to be good.
  if (!watch("Bringing it into the project's folder")) return makeError(ErrorKind::Usage, "stopped");
  std::error_code ignored;
  Result<std::string> name = bringAsset(file, fs::absolute(projectFile, ignored).parent_path());
  if (!name) return name.error();
  const std::shared_ptr<HeightSource> made = *source;
  WL_REQUIRE(made != nullptr, "a file that was read has a source");
  made->file = *name;
  return std::shared_ptr<const HeightSource>(made);
}

}  // namespace

void TerrainLoad::start(const fs::path& file, const fs::path& projectFile) {
  FileLoad::start(file, [=](const LoadWatch& watch) { return load(file, projectFile, watch); });
}

Edit terrainEdit(const Project& project, std::shared_ptr<const HeightSource> source) {
  TerrainSettings terrain = *project.terrain;
  if (source->kind == TerrainKind::HeightMap && terrain.kind != TerrainKind::HeightMap) {
    terrain.centre = project.field->centre;
    terrain.size = project.field->size;
  } else if (source->kind == TerrainKind::Mesh && terrain.kind != TerrainKind::Mesh) {
    terrain.centre = project.field->centre - (source->low + 0.5f * source->size) * terrain.scale;
  }
  terrain.kind = source->kind;
  terrain.file = source->file;
  terrain.heights = placeHeights(terrain, std::move(source));
  return {.label = "Set terrain", .steps = {Set<TerrainSettings>{std::move(terrain)}}, .mergeKey = {}};
}

}  // namespace windloom::editor
