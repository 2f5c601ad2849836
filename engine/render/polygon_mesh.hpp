#pragma once
// Polygon obstacles as triangles: walls, a bevelled edge and a roof.

#include <vector>

#include "engine/model/project.hpp"

namespace windloom {

struct PolygonVertex {
  glm::vec3 position{0.0f};  ///< m, y over 0
  glm::vec3 normal{0.0f};    ///< unit, outwards; walls are flat
  float height = 0.0f;       ///< of the obstacle, m
};

/// Triangles, three vertices each, of all polygons that are not hidden. Their corners must be legal.
std::vector<PolygonVertex> makePolygonMesh(const std::vector<Obstacle>& obstacles, const HeightField* ground = nullptr);

}  // namespace windloom
