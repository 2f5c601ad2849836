#include "editor/core/asset_load.hpp"

#include <algorithm>

#include "engine/io/asset_copy.hpp"
#include "engine/io/assets.hpp"
#include "engine/io/plant_file.hpp"
#include "engine/model/species_presets.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;
namespace {

MeshUse meshUseOf(AssetUse use) {
  return use == AssetUse::Species ? MeshUse::Plant : use == AssetUse::Surface ? MeshUse::Surface : MeshUse::Object;
}

Result<std::string> bring(const fs::path& file, const fs::path& projectFile, const LoadWatch& watch) {
  if (!watch("Bringing it into the project's folder")) return makeError(ErrorKind::Usage, "stopped");
  std::error_code ignored;
  return bringAsset(file, fs::absolute(projectFile, ignored).parent_path());
}

/// Copied only when it is known to be good.
Result<LoadedAsset> load(const AssetTarget& target, const fs::path& file, const fs::path& projectFile,
                         const LoadWatch& watch) {
  LoadedAsset asset{target, nullptr, nullptr};
  if (isPicture(target.use)) {
    const Result<std::shared_ptr<GrassMap>> picture =
        target.use == AssetUse::ShellPicture ? readShellPicture(file) : readGrassMap(file);
    if (!picture) return picture.error();
    const Result<std::string> name = bring(file, projectFile, watch);
    if (!name) return name.error();
    (*picture)->file = *name;
    asset.picture = *picture;
    return asset;
  }
  const Result<std::shared_ptr<PlantMesh>> mesh = readPlantFile(file, meshUseOf(target.use));
  if (!mesh) return mesh.error();
  const Result<std::string> name = bring(file, projectFile, watch);
  if (!name) return name.error();
  (*mesh)->file = *name;
  asset.mesh = *mesh;
  return asset;
}

std::string GrassSettings::*nameOf(AssetUse use) {
  return use == AssetUse::DensityMap  ? &GrassSettings::densityMap
         : use == AssetUse::HeightMap ? &GrassSettings::heightMap
                                      : &GrassSettings::colourMap;
}
std::shared_ptr<const GrassMap> GrassSettings::*pixelsOf(AssetUse use) {
  return use == AssetUse::DensityMap  ? &GrassSettings::densityPixels
         : use == AssetUse::HeightMap ? &GrassSettings::heightPixels
                                      : &GrassSettings::colourPixels;
}

/// A picture's name and pixels as the project has them.
struct PictureOf {
  const std::string& name;
  bool read;
};
PictureOf pictureOf(const Project& project, AssetUse use) {
  if (use == AssetUse::ShellPicture) return {project.shell->texture, project.shell->pixels != nullptr};
  return {(*project.grass).*nameOf(use), (*project.grass).*pixelsOf(use) != nullptr};
}

EditStep withPicture(const Project& project, AssetUse use, std::string name, std::shared_ptr<const GrassMap> pixels) {
  if (use == AssetUse::ShellPicture) {
    ShellSettings shell = *project.shell;
    shell.texture = std::move(name);
    shell.pixels = std::move(pixels);
    return Set<ShellSettings>{std::move(shell)};
  }
  GrassSettings grass = *project.grass;
  grass.*nameOf(use) = std::move(name);
  grass.*pixelsOf(use) = std::move(pixels);
  return Set<GrassSettings>{std::move(grass)};
}

/// "Set map", "Clear picture"
std::string labelOf(const char* verb, AssetUse use) {
  return std::string(verb) + (use == AssetUse::ShellPicture ? " picture" : " map");
}

void give(Species& species, const LoadedAsset& asset) {
  if (species.shape != PlantShape::Mesh) species.height = std::clamp(asset.mesh->high.y, 0.01f, 10.0f);
  species.shape = PlantShape::Mesh;
  species.file = asset.mesh->file;
  species.mesh = asset.mesh;
}
void give(Collider& collider, const LoadedAsset& asset) {
  collider.shape = ColliderShape::Mesh;
  collider.file = asset.mesh->file;
  collider.mesh = asset.mesh;
}

void give(Surface& surface, const LoadedAsset& asset) {
  surface.shape = SurfaceShape::Mesh;
  surface.file = asset.mesh->file;
  surface.mesh = asset.mesh;
}

template <class Record>
void giveEach(Edit& edit, const std::vector<Record>& records, const LoadedAsset& asset) {
  for (Record record : records) {
    if (std::ranges::find(asset.target.ids, record.id) == asset.target.ids.end()) continue;
    give(record, asset);
    edit.steps.emplace_back(Put<Record>{std::move(record)});
  }
}

AddResult addWith(const Project& project, const LoadedAsset& asset) {
  const std::string name = fs::path(asset.file()).stem().string();
  if (asset.target.use == AssetUse::Species) {
    Species species = speciesPreset(PlantShape::Mesh);
    species.name = name;
    species.shape = PlantShape::Blade;  // so that the mesh says how high it is
    give(species, asset);
    return addSpeciesEdit(project, std::move(species));
  }
  if (asset.target.use == AssetUse::Surface) {
    Surface surface;
    surface.name = name;
    surface.position = asset.target.place;
    give(surface, asset);
    return addSurfaceEdit(project, std::move(surface));
  }
  Collider collider;
  collider.name = name;
  collider.position = asset.target.place;
  give(collider, asset);
  return addColliderEdit(project, std::move(collider));
}

/// `ask` is asked about the target's first record; `none` where there is none.
template <class Ask, class Answer>
Answer ofFirst(const Project& project, const AssetTarget& target, Ask&& ask, Answer none) {
  const auto in = [&](const auto& records) {
    for (const auto& record : records) {
      if (std::ranges::find(target.ids, record.id) != target.ids.end()) return ask(record);
    }
    return none;
  };
  return target.use == AssetUse::Species   ? in(*project.species)
         : target.use == AssetUse::Surface ? in(*project.surfaces)
                                           : in(*project.colliders);
}

}  // namespace

bool isPicture(AssetUse use) {
  return use == AssetUse::DensityMap || use == AssetUse::HeightMap || use == AssetUse::ColourMap ||
         use == AssetUse::ShellPicture;
}

const char* assetEndings(AssetUse use) {
  return isPicture(use) ? ".png" : ".glb;.gltf";
}

void AssetLoad::start(AssetTarget target, const fs::path& file, const fs::path& projectFile) {
  FileLoad::start(file, [target = std::move(target), file, projectFile](const LoadWatch& watch) {
    return load(target, file, projectFile, watch);
  });
}

AddResult assetEdit(const Project& project, const LoadedAsset& asset) {
  const AssetTarget& target = asset.target;
  if (isPicture(target.use)) {
    EditStep step = withPicture(project, target.use, asset.picture->file, asset.picture);
    return {{.label = labelOf("Set", target.use), .steps = {std::move(step)}, .mergeKey = {}}, 0};
  }
  if (target.ids.empty()) return addWith(project, asset);
  AddResult result{{.label = "Set file", .steps = {}, .mergeKey = {}}, 0};
  if (target.use == AssetUse::Species) {
    giveEach(result.edit, *project.species, asset);
  } else if (target.use == AssetUse::Surface) {
    giveEach(result.edit, *project.surfaces, asset);
  } else {
    giveEach(result.edit, *project.colliders, asset);
  }
  return result;
}

Edit clearPictureEdit(const Project& project, AssetUse picture) {
  Edit edit{.label = labelOf("Clear", picture), .steps = {}, .mergeKey = {}};
  if (!pictureOf(project, picture).name.empty()) edit.steps.push_back(withPicture(project, picture, {}, nullptr));
  return edit;
}

std::string assetFileOf(const Project& project, const AssetTarget& target) {
  const auto file = [](const auto& record) { return record.file; };
  if (!isPicture(target.use)) return ofFirst(project, target, file, std::string());
  return pictureOf(project, target.use).name;
}

bool isAssetRead(const Project& project, const AssetTarget& target) {
  const auto read = [](const auto& record) { return record.file.empty() || record.mesh != nullptr; };
  if (!isPicture(target.use)) return ofFirst(project, target, read, true);
  const PictureOf picture = pictureOf(project, target.use);
  return picture.name.empty() || picture.read;
}

}  // namespace windloom::editor
