#include "engine/render/polygon_mesh.hpp"

#include <algorithm>

#include "engine/model/outline.hpp"

namespace windloom {
namespace {

constexpr float kSunkM = 0.05f;  // walls begin below the ground, as those of drums and blocks
constexpr float kBevelM = 0.12f;

class Prism {
 public:
  Prism(const Obstacle& obstacle, const HeightField* ground, std::vector<PolygonVertex>& mesh)
      : m_corners(outlineOf(obstacle)),
        m_standing(standingOf(obstacle, ground)),
        m_height(obstacle.height),
        m_mesh(mesh) {
    if (signedArea(m_corners) < 0) std::ranges::reverse(m_corners);
    for (std::size_t i = 0; i < m_corners.size(); ++i) m_roof.push_back(insetCorner(i));
  }

  void build() {
    const float foot = m_standing.footM - kSunkM, top = m_standing.topM;
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
      const std::size_t j = (i + 1) % m_corners.size();
      const glm::vec2 out = outwards(i);
      const glm::vec3 side(out.x, 0.0f, out.y), edge = glm::normalize(side + glm::vec3(0.0f, 1.0f, 0.0f));
      const glm::vec3 a = at(m_corners[i], foot), b = at(m_corners[j], foot);
      const glm::vec3 c = at(m_corners[i], top - m_bevel), d = at(m_corners[j], top - m_bevel);
      quad(a, b, c, d, side);
      quad(c, d, at(m_roof[i], top), at(m_roof[j], top), edge);
    }
    // The roof's corners lie close inside the outline, so that its triangles serve both.
    for (const auto& triangle : triangulate(m_corners))
      for (const std::uint32_t corner : triangle) add(at(m_roof[corner], top), {0.0f, 1.0f, 0.0f});
  }

 private:
  static glm::vec3 at(glm::vec2 place, float y) { return {place.x, y, place.y}; }
  [[nodiscard]] std::size_t before(std::size_t i) const { return (i + m_corners.size() - 1) % m_corners.size(); }
  [[nodiscard]] glm::vec2 sideFrom(std::size_t i) const { return m_corners[(i + 1) % m_corners.size()] - m_corners[i]; }
  /// Of the side that begins at corner i.
  [[nodiscard]] glm::vec2 outwards(std::size_t i) const {
    const glm::vec2 way = glm::normalize(sideFrom(i));
    return {way.y, -way.x};
  }
  /// Moved inwards along the mitre, no farther than short sides and sharp corners have room for.
  [[nodiscard]] glm::vec2 insetCorner(std::size_t i) {
    m_bevel = std::min(kBevelM, 0.2f * m_height);
    const float room = 0.25f * std::min(glm::length(sideFrom(before(i))), glm::length(sideFrom(i)));
    const glm::vec2 a = outwards(before(i)), b = outwards(i);
    const glm::vec2 mitre = (a + b) / std::max(0.25f, 1.0f + glm::dot(a, b));
    return m_corners[i] - std::min(m_bevel, room) * mitre;
  }
  void add(glm::vec3 position, glm::vec3 normal) { m_mesh.push_back({position, normal, m_height}); }
  void quad(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, glm::vec3 normal) {
    for (const glm::vec3 corner : {a, b, c, c, b, d}) add(corner, normal);
  }

  std::vector<glm::vec2> m_corners, m_roof;
  Standing m_standing;
  float m_height, m_bevel = 0.0f;
  std::vector<PolygonVertex>& m_mesh;
};

}  // namespace

std::vector<PolygonVertex> makePolygonMesh(const std::vector<Obstacle>& obstacles, const HeightField* ground) {
  std::vector<PolygonVertex> mesh;
  for (const Obstacle& obstacle : obstacles) {
    if (obstacle.shape == ObstacleShape::Polygon && !obstacle.hidden) Prism(obstacle, ground, mesh).build();
  }
  return mesh;
}

}  // namespace windloom
