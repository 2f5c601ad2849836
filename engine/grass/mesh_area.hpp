#pragma once
// A triangle mesh as something that Bezier grass grows on, uniformly over its area.

#include <memory>
#include <vector>

#include "engine/core/thread_pool.hpp"
#include "engine/grass/growth_area.hpp"
#include "engine/model/plant_mesh.hpp"

namespace windloom {

/// Meshes with more triangles carry single blades alone: the neighbours that tufts need would take too long to find.
inline constexpr std::size_t kMostTuftTriangles = 2'000'000;

/// Triangles without area, with indices beyond the vertices or with corners that aren't finite (or beyond 1000 km) grow
/// nothing. Where a vertex's normal can't be used, the triangle's own stands for it.
class MeshArea final : public GrowthArea {
 public:
  /// `pose` moves, turns and scales evenly. `bothSides`: grows on the backs as well. `tufts`: beside() will be asked
  /// for.
  MeshArea(std::shared_ptr<const PlantMesh> mesh, const glm::mat4& pose, bool bothSides, bool tufts, ThreadPool& pool);

  [[nodiscard]] int parts() const override { return 1; }
  [[nodiscard]] double area(int) const override { return m_sides * m_oneSide; }
  [[nodiscard]] GrowthPoint at(int part, double along, RandomStream& random) const override;
  [[nodiscard]] bool holdsTufts() const override { return !m_neighbours.empty(); }
  /// Straight on over the triangles, as an ant walks; it ends at a border.
  [[nodiscard]] std::optional<GrowthPoint> beside(int part, const GrowthPoint& from, glm::vec3 offset,
                                                  RandomStream& random) const override;

 private:
  struct Corners {
    glm::vec3 a, b, c;
  };

  [[nodiscard]] std::size_t triangles() const { return m_mesh->indices.size() / 3; }
  [[nodiscard]] Corners corners(std::size_t triangle) const;
  [[nodiscard]] double areaOf(std::size_t triangle) const;
  void findNeighbours();
  [[nodiscard]] GrowthPoint pointIn(std::size_t triangle, glm::vec2 part, bool back) const;
  bool step(std::size_t& triangle, glm::vec3& place, glm::vec3& way, bool& back) const;

  std::shared_ptr<const PlantMesh> m_mesh;
  glm::mat4 m_pose;
  double m_sides = 1, m_oneSide = 0;
  std::vector<double> m_sums;  // of the areas up to and with each triangle
  std::vector<std::uint32_t>
      m_neighbours;  // of each edge (3 a triangle): the same edge of the other triangle, or kNone
};

}  // namespace windloom
