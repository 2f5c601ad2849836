#include "engine/grass/mesh_simplify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "engine/core/contract.hpp"
#include "shaders/shared/hash.h"

namespace windloom {
namespace {

constexpr std::size_t kLeastPieces = 8;  // fewer kept pieces would leave holes
constexpr float kMostGrowth = 2.0f;

using Triangle = std::array<std::uint32_t, 3>;

struct Piece {
  std::vector<Triangle> triangles;
  glm::vec3 middle{0.0f};
  float area = 0.0f;
};

/// Groups of vertices that triangles join; vertices at the same place count as one.
class Groups {
 public:
  explicit Groups(const PlantMesh& mesh) : m_parent(mesh.vertices.size()) {
    std::iota(m_parent.begin(), m_parent.end(), 0u);
    std::map<std::tuple<float, float, float>, std::uint32_t> places;
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
      const glm::vec3 p = mesh.vertices[i].position;
      join(i, places.emplace(std::tuple(p.x, p.y, p.z), i).first->second);
    }
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
      join(mesh.indices[t], mesh.indices[t + 1]);
      join(mesh.indices[t], mesh.indices[t + 2]);
    }
  }
  std::uint32_t of(std::uint32_t vertex) {
    while (m_parent[vertex] != vertex) vertex = m_parent[vertex] = m_parent[m_parent[vertex]];
    return vertex;
  }

 private:
  void join(std::uint32_t a, std::uint32_t b) { m_parent[of(a)] = of(b); }
  std::vector<std::uint32_t> m_parent;
};

std::vector<Piece> piecesOf(const PlantMesh& mesh) {
  Groups groups(mesh);
  std::map<std::uint32_t, Piece> found;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const Triangle triangle{mesh.indices[t], mesh.indices[t + 1], mesh.indices[t + 2]};
    const glm::vec3 a = mesh.vertices[triangle[0]].position, b = mesh.vertices[triangle[1]].position,
                    c = mesh.vertices[triangle[2]].position;
    Piece& piece = found[groups.of(triangle[0])];
    const float area = 0.5f * glm::length(glm::cross(b - a, c - a));
    piece.triangles.push_back(triangle);
    piece.middle += (a + b + c) * (area / 3.0f);
    piece.area += area;
  }
  std::vector<Piece> pieces;
  for (auto& [group, piece] : found) {
    if (piece.area <= 0.0f) continue;
    piece.middle /= piece.area;
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// Pieces in a mixed order until the triangles are used up, grown about their middles.
PlantMesh fewerPieces(const PlantMesh& mesh, const std::vector<Piece>& pieces, std::size_t most) {
  std::vector<std::size_t> order(pieces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [](std::size_t i) { return shared::pcgHash(static_cast<std::uint32_t>(i)); });
  float all = 0.0f, kept = 0.0f;
  for (const Piece& piece : pieces) all += piece.area;
  std::vector<std::size_t> chosen;
  std::size_t used = 0;
  for (const std::size_t i : order) {
    if (used + pieces[i].triangles.size() > most) continue;
    used += pieces[i].triangles.size();
    kept += pieces[i].area;
    chosen.push_back(i);
  }
  const float growth = std::min(std::sqrt(all / std::max(kept, 1e-12f)), kMostGrowth);
  PlantMesh result;
  for (const std::size_t i : chosen) {
    std::map<std::uint32_t, std::uint32_t> names;
    for (const Triangle& triangle : pieces[i].triangles) {
      for (const std::uint32_t old : triangle) {
        const auto [name, fresh] = names.emplace(old, static_cast<std::uint32_t>(result.vertices.size()));
        if (fresh) {
          PlantVertex vertex = mesh.vertices[old];
          vertex.position = pieces[i].middle + (vertex.position - pieces[i].middle) * growth;
          vertex.position.y = std::clamp(vertex.position.y, mesh.low.y, mesh.high.y);
          result.vertices.push_back(vertex);
        }
        result.indices.push_back(name->second);
      }
    }
  }
  return result;
}

/// Vertices of a cell become one.
PlantMesh merged(const PlantMesh& mesh, int cells) {
  const glm::vec3 size = glm::max(mesh.high - mesh.low, glm::vec3(1e-6f));
  const float side = std::max({size.x, size.y, size.z}) / static_cast<float>(cells);
  PlantMesh result;
  std::vector<float> counts;
  std::map<std::tuple<int, int, int>, std::uint32_t> names;
  std::vector<std::uint32_t> nameOf;
  for (const PlantVertex& vertex : mesh.vertices) {
    const glm::ivec3 cell = glm::ivec3(glm::floor((vertex.position - mesh.low) / side));
    const auto [name, fresh] =
        names.emplace(std::tuple(cell.x, cell.y, cell.z), static_cast<std::uint32_t>(result.vertices.size()));
    nameOf.push_back(name->second);
    if (fresh) {
      result.vertices.push_back(vertex);
      counts.push_back(1.0f);
      continue;
    }
    PlantVertex& whole = result.vertices[name->second];
    whole.position += vertex.position;
    whole.normal += vertex.normal;
    whole.colour += vertex.colour;
    counts[name->second] += 1.0f;
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    PlantVertex& whole = result.vertices[i];
    whole.position /= counts[i];
    whole.colour /= counts[i];
    const float length = glm::length(whole.normal);
    whole.normal = length > 1e-6f ? whole.normal / length : glm::vec3(0, 1, 0);
  }
  std::set<Triangle> known;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const Triangle now{nameOf[mesh.indices[t]], nameOf[mesh.indices[t + 1]], nameOf[mesh.indices[t + 2]]};
    Triangle sorted = now;
    std::ranges::sort(sorted);
    if (sorted[0] == sorted[1] || sorted[1] == sorted[2] || !known.insert(sorted).second) continue;
    result.indices.insert(result.indices.end(), now.begin(), now.end());
  }
  return result;
}

}  // namespace

PlantMesh simplified(const PlantMesh& mesh, std::size_t triangles) {
  WL_REQUIRE(triangles >= 4, "a mesh keeps some triangles");
  PlantMesh result;
  if (mesh.indices.size() <= 3 * triangles) {
    result.vertices = mesh.vertices;
    result.indices = mesh.indices;
  } else {
    const std::vector<Piece> pieces = piecesOf(mesh);
    const std::size_t whole = mesh.indices.size() / 3;
    if (pieces.size() * triangles >= kLeastPieces * whole) result = fewerPieces(mesh, pieces, triangles);
    for (int cells = 16; result.indices.empty() && cells >= 1; --cells) {
      PlantMesh coarse = merged(mesh, cells);
      if (!coarse.indices.empty() && coarse.indices.size() <= 3 * triangles) result = std::move(coarse);
    }
    // Nothing may be left of a mesh that is thin everywhere: every so many of its triangles stand for it.
    if (result.indices.empty()) {
      result.vertices = mesh.vertices;
      for (std::size_t t = 0; t < triangles; ++t) {
        const auto from = mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * (t * whole / triangles));
        result.indices.insert(result.indices.end(), from, from + 3);
      }
    }
  }
  result.low = mesh.low;
  result.high = mesh.high;
  result.alphaCutoff = mesh.alphaCutoff;
  return result;
}

}  // namespace windloom
