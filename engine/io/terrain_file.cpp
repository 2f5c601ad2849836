#include "engine/io/terrain_file.hpp"

#include <algorithm>
#include <cctype>

#include "engine/core/out_of_memory.hpp"
#include "engine/io/image.hpp"
#include "engine/io/terrain_mesh.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

Error refuse(const fs::path& file, std::string message) {
  return makeError(ErrorKind::BadInput, file.string(), {}, std::move(message));
}

/// 0..1.
float greyOf(const Image16& image, int x, int y) {
  const std::uint16_t* pixel = image.at(x, y);
  constexpr float kWhite = 65535.0f;
  if (image.channels == 1) return static_cast<float>(pixel[0]) / kWhite;
  return (0.2126f * static_cast<float>(pixel[0]) + 0.7152f * static_cast<float>(pixel[1]) +
          0.0722f * static_cast<float>(pixel[2])) /
         kWhite;
}

/// Mean of the pixels that a sample stands for; the outer samples stand for the outer pixels' middles.
float meanAround(const Image16& image, glm::vec2 at, glm::vec2 pixelsPerSample) {
  const glm::vec2 reach = 0.5f * glm::max(pixelsPerSample - 1.0f, glm::vec2(0.0f));
  const glm::ivec2 last(image.width - 1, image.height - 1);
  const glm::ivec2 low = glm::clamp(glm::ivec2(glm::round(at - reach)), glm::ivec2(0), last);
  const glm::ivec2 high = glm::clamp(glm::ivec2(glm::round(at + reach)), low, last);
  double sum = 0;
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) sum += static_cast<double>(greyOf(image, x, y));
  }
  return static_cast<float>(sum / static_cast<double>((high.x - low.x + 1) * (high.y - low.y + 1)));
}

Result<std::shared_ptr<HeightSource>> readPicture(const fs::path& file, const LoadWatch& watch) {
  const Result<Image16> image = readPng16(file);
  if (!image) return image.error();
  if (std::min(image->width, image->height) < 2)
    return refuse(file, "has fewer than 2 pixels a side, too few for a landscape");
  if (std::max(image->width, image->height) > kMaxTerrainPicture) {
    return refuse(file, "has " + std::to_string(std::max(image->width, image->height)) +
                            " pixels a side, expected at most " + std::to_string(kMaxTerrainPicture));
  }
  if (watch && !watch("Making heights")) return makeError(ErrorKind::Usage, "stopped");
  auto source = std::make_shared<HeightSource>();
  source->pixels = {image->width, image->height};
  source->samples = glm::min(source->pixels, glm::ivec2(kMaxHeightSamples));
  source->values.reserve(static_cast<std::size_t>(source->samples.x) * static_cast<std::size_t>(source->samples.y));
  const glm::vec2 step = glm::vec2(source->pixels - 1) / glm::vec2(source->samples - 1);
  for (int k = 0; k < source->samples.y; ++k) {
    for (int i = 0; i < source->samples.x; ++i)
      source->values.push_back(meanAround(*image, glm::vec2(i, k) * step, step));
  }
  return source;
}

void findRange(HeightSource& source) {
  const auto [low, high] = std::ranges::minmax_element(source.values);
  source.lowest = *low;
  source.highest = *high;
}

}  // namespace

std::optional<TerrainKind> terrainKindOf(const fs::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".png") return TerrainKind::HeightMap;
  if (ending == ".glb" || ending == ".gltf") return TerrainKind::Mesh;
  return std::nullopt;
}

Result<std::shared_ptr<HeightSource>> readTerrainFile(const fs::path& file, TerrainKind kind, const LoadWatch& watch,
                                                      const FileAccess& access) {
  const bool picture = kind == TerrainKind::HeightMap;
  if (terrainKindOf(file) != kind) {
    return refuse(file, picture ? "is no height map, expected a PNG picture (.png)"
                                : "is no mesh, expected a glTF file (.glb or .gltf)");
  }
  if (watch && !watch("Reading " + file.filename().string())) return makeError(ErrorKind::Usage, "stopped");
  const auto read = [&]() -> Result<std::shared_ptr<HeightSource>> {
    if (picture) return readPicture(file, watch);
    const Result<TriangleMesh> mesh = readMesh(file, watch, access);
    if (!mesh) return mesh.error();
    return heightsOfMesh(*mesh, file, watch);
  };
  Result<std::shared_ptr<HeightSource>> source = orOutOfMemory(file.string(), read);
  if (!source) return source;
  (*source)->kind = kind;
  findRange(**source);
  return source;
}

Status loadTerrain(Project& project, const fs::path& projectFile, OutsideFiles outside) {
  if (project.terrain->kind == TerrainKind::Flat) return Done{};
  TerrainSettings terrain = *project.terrain;
  const Result<fs::path> file = findAsset(projectFile, terrain.file, outside);
  Result<std::shared_ptr<HeightSource>> source =
      file ? readTerrainFile(*file, terrain.kind, {}, accessOf(projectFile, outside)) : file.error();
  if (!source) {
    Error error = source.error();
    for (Problem& problem : error.problems) problem = {projectFile.string(), "/terrain/file", problem.text()};
    return error;
  }
  (*source)->file = terrain.file;
  terrain.heights = placeHeights(terrain, std::move(*source));
  project.terrain = std::make_shared<TerrainSettings>(std::move(terrain));
  return Done{};
}

}  // namespace windloom
