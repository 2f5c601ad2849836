#include "engine/io/assets.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/core/out_of_memory.hpp"
#include "engine/io/image.hpp"
#include "engine/io/plant_file.hpp"
#include "engine/model/sphere_packing.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

enum class MapUse { Field, Blades };

/// Reads each file once and keeps what went wrong.
class Loader {
 public:
  Loader(const fs::path& projectFile, OutsideFiles outside) : m_projectFile(projectFile), m_outside(outside) {}

  void know(MeshUse use, const std::shared_ptr<const PlantMesh>& mesh) {
    if (mesh) m_meshes[{use, mesh->file}] = mesh;
  }
  void know(MapUse use, const std::shared_ptr<const GrassMap>& map) {
    if (map) m_maps[{use, map->file}] = map;
  }

  /// True where `mesh` was changed.
  bool fill(std::shared_ptr<const PlantMesh>& mesh, const std::string& file, MeshUse use, const std::string& pointer) {
    if (mesh && mesh->file == file) return false;
    auto& known = m_meshes[{use, file}];
    if (!known) {
      const Result<fs::path> path = findAsset(m_projectFile, file, m_outside);
      if (!path) return note(path.error(), pointer);
      Result<std::shared_ptr<PlantMesh>> read = readPlantFile(*path, use, accessOf(m_projectFile, m_outside));
      if (!read) return note(read.error(), pointer);
      const std::size_t triangles = (*read)->indices.size() / 3;
      if (triangles > m_trianglesLeft) {
        return note(makeError(ErrorKind::BadInput, file, {},
                              "makes more than " + std::to_string(kMaxProjectTriangles / 1'000'000) +
                                  " million triangles in all meshes of the project"),
                    pointer);
      }
      m_trianglesLeft -= triangles;
      (*read)->file = file;
      known = *read;
    }
    mesh = known;
    return true;
  }

  bool fill(std::shared_ptr<const GrassMap>& map, const std::string& file, MapUse use, const std::string& pointer) {
    if (file.empty()) return std::exchange(map, nullptr) != nullptr;
    if (map && map->file == file) return false;
    auto& known = m_maps[{use, file}];
    if (!known) {
      const Result<fs::path> path = findAsset(m_projectFile, file, m_outside);
      if (!path) return note(path.error(), pointer);
      Result<std::shared_ptr<GrassMap>> read =
          orOutOfMemory(file, [&] { return use == MapUse::Blades ? readShellPicture(*path) : readGrassMap(*path); });
      if (!read) return note(read.error(), pointer);
      (*read)->file = file;
      known = *read;
    }
    map = known;
    return true;
  }

  Status finish() {
    if (m_problems.empty()) return Done{};
    return Error{ErrorKind::BadInput, std::move(m_problems)};
  }

 private:
  bool note(const Error& error, const std::string& pointer) {
    for (const Problem& problem : error.problems)
      m_problems.push_back({m_projectFile.string(), pointer, problem.text()});
    return false;
  }

  fs::path m_projectFile;
  OutsideFiles m_outside;
  std::map<std::pair<MeshUse, std::string>, std::shared_ptr<const PlantMesh>> m_meshes;
  std::map<std::pair<MapUse, std::string>, std::shared_ptr<const GrassMap>> m_maps;
  std::vector<Problem> m_problems;
  std::size_t m_trianglesLeft = kMaxProjectTriangles;
};

void fillSpecies(Project& project, Loader& loader) {
  std::vector<Species> all = *project.species;
  for (const Species& one : all) {
    if (one.shape == PlantShape::Mesh) loader.know(MeshUse::Plant, one.mesh);
  }
  bool changed = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].shape != PlantShape::Mesh) continue;
    changed |= loader.fill(all[i].mesh, all[i].file, MeshUse::Plant, "/species/" + std::to_string(i) + "/file");
  }
  if (changed) project.species = std::make_shared<std::vector<Species>>(std::move(all));
}

void fillColliders(Project& project, Loader& loader) {
  std::vector<Collider> all = *project.colliders;
  for (const Collider& one : all) {
    if (one.shape == ColliderShape::Mesh) loader.know(MeshUse::Object, one.mesh);
  }
  bool changed = false;
  std::map<std::pair<const PlantMesh*, int>, std::shared_ptr<const PlantMesh>>
      packings;  // shared by those that want the same
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].shape != ColliderShape::Mesh) continue;
    changed |= loader.fill(all[i].mesh, all[i].file, MeshUse::Object, "/colliders/" + std::to_string(i) + "/file");
    std::shared_ptr<const PlantMesh>& packed = packings[{all[i].mesh.get(), all[i].spheres}];
    if (!packed) packed = packedWith(all[i].mesh, all[i].spheres);
    changed |= std::exchange(all[i].mesh, packed) != packed;
  }
  if (changed) project.colliders = std::make_shared<std::vector<Collider>>(std::move(all));
}

void fillSurfaces(Project& project, Loader& loader) {
  std::vector<Surface> all = *project.surfaces;
  for (const Surface& one : all) {
    if (one.shape == SurfaceShape::Mesh) loader.know(MeshUse::Surface, one.mesh);
  }
  bool changed = false;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].shape != SurfaceShape::Mesh) continue;
    changed |= loader.fill(all[i].mesh, all[i].file, MeshUse::Surface, "/surfaces/" + std::to_string(i) + "/file");
  }
  if (changed) project.surfaces = std::make_shared<std::vector<Surface>>(std::move(all));
}

void fillMaps(Project& project, Loader& loader) {
  GrassSettings grass = *project.grass;
  for (const auto& map : {grass.densityPixels, grass.heightPixels, grass.colourPixels}) loader.know(MapUse::Field, map);
  bool changed = loader.fill(grass.densityPixels, grass.densityMap, MapUse::Field, "/grass/maps/density");
  changed |= loader.fill(grass.heightPixels, grass.heightMap, MapUse::Field, "/grass/maps/height");
  changed |= loader.fill(grass.colourPixels, grass.colourMap, MapUse::Field, "/grass/maps/colour");
  if (changed) project.grass = std::make_shared<GrassSettings>(std::move(grass));
}

void fillShell(Project& project, Loader& loader) {
  ShellSettings shell = *project.shell;
  if (loader.fill(shell.pixels, shell.texture, MapUse::Blades, "/shell/texture/file"))
    project.shell = std::make_shared<ShellSettings>(std::move(shell));
}

std::uint8_t meanByte(double sum, int count) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(sum / count * (255.0 / 65535.0)), 0l, 255l));
}

}  // namespace

Result<std::shared_ptr<GrassMap>> readGrassMap(const fs::path& file) {
  const Result<Image16> image = readPng16(file);
  if (!image) return image.error();
  auto map = std::make_shared<GrassMap>();
  const int factor = (std::max(image->width, image->height) + kMaxGrassMap - 1) / kMaxGrassMap;
  map->size = {(image->width + factor - 1) / factor, (image->height + factor - 1) / factor};
  map->pixels.reserve(static_cast<std::size_t>(map->size.x) * static_cast<std::size_t>(map->size.y) * 4);
  for (int y = 0; y < map->size.y; ++y) {
    for (int x = 0; x < map->size.x; ++x) {
      double sum[4] = {};
      int count = 0;
      for (int v = y * factor; v < std::min((y + 1) * factor, image->height); ++v) {
        for (int u = x * factor; u < std::min((x + 1) * factor, image->width); ++u, ++count) {
          const std::uint16_t* in = image->at(u, v);
          for (int c = 0; c < 3; ++c) sum[c] += image->channels == 1 ? in[0] : in[c];
          sum[3] += image->channels == 4 ? in[3] : 65535.0;
        }
      }
      for (const double one : sum) map->pixels.push_back(meanByte(one, count));
    }
  }
  return map;
}

Result<std::shared_ptr<GrassMap>> readShellPicture(const fs::path& file) {
  Result<std::shared_ptr<GrassMap>> picture = readGrassMap(file);
  if (!picture) return picture;
  int least = 255, most = 0;
  for (std::size_t alpha = 3; alpha < (*picture)->pixels.size(); alpha += 4) {
    least = std::min<int>(least, (*picture)->pixels[alpha]);
    most = std::max<int>(most, (*picture)->pixels[alpha]);
  }
  const char* expected = ": expected the height of the blades in alpha, 0 where there is bare ground";
  if (most == 0)
    return makeError(ErrorKind::BadInput, file.string(), {}, std::string("holds no blade, its alpha is 0") + expected);
  if (least == 255) {
    return makeError(ErrorKind::BadInput, file.string(), {},
                     std::string("has no transparency, so that nothing would be cut out") + expected);
  }
  return picture;
}

Status loadAssets(Project& project, const fs::path& projectFile, OutsideFiles outside) {
  Loader loader(projectFile, outside);
  fillSpecies(project, loader);
  fillColliders(project, loader);
  fillSurfaces(project, loader);
  fillMaps(project, loader);
  fillShell(project, loader);
  return loader.finish();
}

}  // namespace windloom
