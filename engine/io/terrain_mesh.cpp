#include "engine/io/terrain_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "engine/io/gltf_file.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

using gltf::refuse;

Error stopped() {
  return makeError(ErrorKind::Usage, "stopped");
}

/// All triangles of the scene.
Result<TriangleMesh> collect(const tinygltf::Model& model, const fs::path& file) {
  const Result<std::vector<gltf::PlacedMesh>> placed = gltf::meshesOfScene(model, file);
  if (!placed) return placed.error();
  TriangleMesh all;
  for (const gltf::PlacedMesh& one : *placed) {
    for (const tinygltf::Primitive& primitive : model.meshes[one.mesh].primitives) {
      const auto position = primitive.attributes.find("POSITION");
      if (!gltf::isTriangles(primitive) || position == primitive.attributes.end()) continue;
      const std::size_t first = all.vertices.size();
      Status added = gltf::appendPositions(model, position->second, one.world, kMaxTerrainVertices, file, all.vertices);
      if (!added) return added.error();
      added = gltf::appendIndices(model, primitive.indices, first, all.vertices.size() - first, 3 * kMaxTerrainVertices,
                                  file, all.indices);
      if (!added) return added.error();
    }
  }
  if (all.indices.empty()) return refuse(file, "has no triangles in its scene");
  return all;
}

// Samples looked at until the watch is asked again, a part of a second; a triangle itself counts as some.
constexpr std::size_t kWorkBetweenWatches = 10'000'000, kTriangleWork = 50;

constexpr float kNothing = std::numeric_limits<float>::lowest();

/// Raises the samples under a triangle to it and says how many were looked at. `a`, `b`, `c`: x and z in grid
/// coordinates, y in metres.
std::size_t drawTriangle(HeightSource& source, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const double area = (b.x - a.x) * (c.z - a.z) - (c.x - a.x) * (b.z - a.z);
  if (std::abs(area) < 1e-12) return 0;
  const auto bound = [](double x, double y, double z, int last, int& low, int& high) {
    low = std::max(0, static_cast<int>(std::ceil(std::min({x, y, z}) - 1e-6)));
    high = std::min(last, static_cast<int>(std::floor(std::max({x, y, z}) + 1e-6)));
  };
  int x0, x1, z0, z1;
  bound(a.x, b.x, c.x, source.samples.x - 1, x0, x1);
  bound(a.z, b.z, c.z, source.samples.y - 1, z0, z1);
  constexpr double kEdge = -1e-7;  // a sample on an edge belongs to both sides
  for (int k = z0; k <= z1; ++k) {
    for (int i = x0; i <= x1; ++i) {
      const double v = ((i - a.x) * (c.z - a.z) - (c.x - a.x) * (k - a.z)) / area;
      const double w = ((b.x - a.x) * (k - a.z) - (i - a.x) * (b.z - a.z)) / area;
      if (v < kEdge || w < kEdge || 1.0 - v - w < kEdge) continue;
      float& value = source.values[static_cast<std::size_t>(k) * static_cast<std::size_t>(source.samples.x) +
                                   static_cast<std::size_t>(i)];
      value = std::max(value, static_cast<float>(a.y + v * (b.y - a.y) + w * (c.y - a.y)));
    }
  }
  return static_cast<std::size_t>(std::max(0, x1 - x0 + 1)) * static_cast<std::size_t>(std::max(0, z1 - z0 + 1));
}

/// Samples without a triangle take the mean of their neighbours that have a height, from the rims of a hole inwards.
void fillHoles(HeightSource& source) {
  const int width = source.samples.x, depth = source.samples.y;
  const auto at = [&](int i, int k) -> float& {
    return source.values[static_cast<std::size_t>(k) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
  };
  std::vector<glm::ivec2> rim;
  const auto hasNeighbour = [&](int i, int k) {
    return (i > 0 && at(i - 1, k) != kNothing) || (i + 1 < width && at(i + 1, k) != kNothing) ||
           (k > 0 && at(i, k - 1) != kNothing) || (k + 1 < depth && at(i, k + 1) != kNothing);
  };
  for (int k = 0; k < depth; ++k) {
    for (int i = 0; i < width; ++i) {
      if (at(i, k) == kNothing && hasNeighbour(i, k)) rim.emplace_back(i, k);
    }
  }
  while (!rim.empty()) {
    std::vector<float> found;
    for (const glm::ivec2 p : rim) {
      double sum = 0;
      int count = 0;
      for (int k = std::max(0, p.y - 1); k <= std::min(depth - 1, p.y + 1); ++k) {
        for (int i = std::max(0, p.x - 1); i <= std::min(width - 1, p.x + 1); ++i) {
          if (at(i, k) == kNothing) continue;
          sum += static_cast<double>(at(i, k));
          ++count;
        }
      }
      found.push_back(static_cast<float>(sum / count));
    }
    for (std::size_t n = 0; n < rim.size(); ++n) at(rim[n].x, rim[n].y) = found[n];
    std::vector<glm::ivec2> next;
    for (const glm::ivec2 p : rim) {
      for (const glm::ivec2 way : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
        const glm::ivec2 q = p + way;
        if (q.x >= 0 && q.y >= 0 && q.x < width && q.y < depth && at(q.x, q.y) == kNothing) next.push_back(q);
      }
    }
    std::ranges::sort(next, {}, [](glm::ivec2 p) { return std::pair(p.y, p.x); });
    next.erase(std::unique(next.begin(), next.end()), next.end());
    rim = std::move(next);
  }
}

}  // namespace

Result<TriangleMesh> readMesh(const fs::path& file, const LoadWatch& watch, const FileAccess& access) {
  const Result<tinygltf::Model> model = gltf::parse(file, gltf::Pictures::Leave, access);
  if (!model) return model.error();
  if (watch && !watch("Gathering triangles")) return stopped();
  return collect(*model, file);
}

Result<std::shared_ptr<HeightSource>> heightsOfMesh(const TriangleMesh& mesh, const fs::path& file,
                                                    const LoadWatch& watch) {
  glm::vec3 low = mesh.vertices[mesh.indices.front()], high = low;
  for (const std::uint32_t index : mesh.indices) {
    low = glm::min(low, mesh.vertices[index]);
    high = glm::max(high, mesh.vertices[index]);
  }
  auto source = std::make_shared<HeightSource>();
  source->triangles = mesh.indices.size() / 3;
  source->low = {low.x, low.z};
  source->size = {high.x - low.x, high.z - low.z};
  const float longest = std::max(source->size.x, source->size.y), shortest = std::min(source->size.x, source->size.y);
  if (!(shortest > 1e-4f) || !(shortest > longest * 1e-3f))
    return refuse(file, "covers no ground: it is a wall or a line seen from above");
  const double along =
      std::clamp(2.0 * std::sqrt(0.5 * static_cast<double>(source->triangles)), 256.0, double(kMaxHeightSamples));
  source->samples = glm::max(glm::ivec2(glm::round(source->size / longest * static_cast<float>(along))), glm::ivec2(2));
  source->values.assign(static_cast<std::size_t>(source->samples.x) * static_cast<std::size_t>(source->samples.y),
                        kNothing);
  const glm::dvec2 perMetre = glm::dvec2(source->samples - 1) / glm::dvec2(source->size);
  const auto onGrid = [&](std::uint32_t index) {
    const glm::dvec3 at(mesh.vertices[index]);
    return glm::dvec3((at.x - static_cast<double>(low.x)) * perMetre.x, at.y,
                      (at.z - static_cast<double>(low.z)) * perMetre.y);
  };
  std::size_t work = kWorkBetweenWatches, drawnSamples = 0;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    if (watch && work >= kWorkBetweenWatches) {
      work = 0;
      const auto percent = 100 * t / mesh.indices.size();
      if (!watch("Making heights, " + std::to_string(percent) + "%")) return stopped();
    }
    const std::size_t drawn =
        drawTriangle(*source, onGrid(mesh.indices[t]), onGrid(mesh.indices[t + 1]), onGrid(mesh.indices[t + 2]));
    work += kTriangleWork + drawn;
    drawnSamples += drawn;
    if (drawnSamples > kMaxDrawnSamples)
      return refuse(file, "has too many triangles that lie over each other: expected ground, one or a few layers");
  }
  if (std::ranges::all_of(source->values, [](float v) { return v == kNothing; }))
    return refuse(file, "covers no ground: all its triangles stand upright");
  fillHoles(*source);
  return source;
}

}  // namespace windloom
