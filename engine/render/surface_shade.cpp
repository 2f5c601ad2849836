// Lloyd's algorithm (Lloyd, "Least squares quantization in PCM", 1982) over the triangles' middles.
#include "engine/render/surface_shade.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

constexpr std::size_t kMostPieces = 8000;  // triangles that are looked at
constexpr int kRounds = 6;
// Of the radius of a disc with a cluster's area: bodies show two sides of their skin to the sun, sheets one.
constexpr float kRadius = 0.72f;

struct Piece {
  glm::vec3 middle{0.0f};
  float area = 0;
};

std::vector<Piece> piecesOf(const PlantMesh& mesh, const glm::mat4& world) {
  const std::size_t triangles = mesh.indices.size() / 3, stride = triangles / kMostPieces + 1;
  const auto corner = [&](std::size_t index) {
    return glm::vec3(world * glm::vec4(mesh.vertices[mesh.indices[index]].position, 1.0f));
  };
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i < triangles; i += stride) {
    const glm::vec3 a = corner(3 * i), b = corner(3 * i + 1), c = corner(3 * i + 2);
    const float area = 0.5f * glm::length(glm::cross(b - a, c - a)) * static_cast<float>(stride);
    if (area > 0.0f && std::isfinite(area)) pieces.push_back({(a + b + c) / 3.0f, area});
  }
  return pieces;
}

std::size_t nearestOf(const std::vector<glm::vec4>& centres, glm::vec3 place) {
  const auto away = [place](glm::vec4 centre) {
    return glm::dot(glm::vec3(centre) - place, glm::vec3(centre) - place);
  };
  return static_cast<std::size_t>(std::ranges::min_element(centres, {}, away) - centres.begin());
}

}  // namespace

std::vector<glm::vec4> surfaceShades(const PlantMesh& mesh, const glm::mat4& world, std::size_t count) {
  const std::vector<Piece> pieces = piecesOf(mesh, world);
  count = std::min(count, pieces.size());
  std::vector<glm::vec4> centres;
  for (std::size_t i = 0; i < count; ++i) centres.emplace_back(pieces[i * pieces.size() / count].middle, 0.0f);
  for (int round = 0; round < kRounds && count > 0; ++round) {
    std::vector<glm::vec4> sums(count, glm::vec4(0.0f));  // w area
    for (const Piece& piece : pieces) {
      sums[nearestOf(centres, piece.middle)] += glm::vec4(piece.middle * piece.area, piece.area);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (sums[i].w <= 0.0f) continue;
      centres[i] = {glm::vec3(sums[i]) / sums[i].w, kRadius * std::sqrt(sums[i].w / 3.14159265f)};
    }
  }
  std::erase_if(centres, [](glm::vec4 centre) { return centre.w <= 0.0f; });
  return centres;
}

}  // namespace windloom
