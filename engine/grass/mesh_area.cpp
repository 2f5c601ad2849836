#include "engine/grass/mesh_area.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace windloom {
namespace {

constexpr std::uint32_t kNone = ~0u;
constexpr float kFarM = 1e6f;
constexpr int kMostSteps = 256;  // from triangle to triangle
constexpr std::size_t kChunk = 16384;

bool usable(const glm::vec3& v) {
  return std::abs(v.x) <= kFarM && std::abs(v.y) <= kFarM && std::abs(v.z) <= kFarM;  // false for NaN
}

/// Vertices that stand at one place get one number, so that seams of normals and coordinates don't part triangles.
std::vector<std::uint32_t> welded(const std::vector<PlantVertex>& vertices) {
  std::vector<std::uint32_t> first(vertices.size());
  std::vector<std::uint32_t> order(vertices.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::uint32_t i) {
    const glm::vec3 p = vertices[i].position + 0.0f;  // -0 becomes 0
    std::uint32_t bits[3];
    std::memcpy(bits, &p, sizeof bits);
    return std::array<std::uint32_t, 3>{bits[0], bits[1], bits[2]};
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const auto ka = key(a), kb = key(b);
    return ka != kb ? ka < kb : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  return first;
}

}  // namespace

MeshArea::MeshArea(std::shared_ptr<const PlantMesh> mesh, const glm::mat4& pose, bool bothSides, bool tufts,
                   ThreadPool& pool)
    : m_mesh(std::move(mesh)), m_pose(pose), m_sides(bothSides ? 2.0 : 1.0) {
  m_sums.resize(triangles());
  pool.parallelFor(static_cast<int>((m_sums.size() + kChunk - 1) / kChunk), [&](int chunk) {
    const std::size_t from = static_cast<std::size_t>(chunk) * kChunk;
    for (std::size_t t = from; t < std::min(from + kChunk, m_sums.size()); ++t) m_sums[t] = areaOf(t);
  });
  for (double& sum : m_sums) sum = m_oneSide += sum;
  if (tufts && m_oneSide > 0 && triangles() <= kMostTuftTriangles) findNeighbours();
}

MeshArea::Corners MeshArea::corners(std::size_t triangle) const {
  const auto at = [&](std::size_t i) {
    return glm::vec3(m_pose * glm::vec4(m_mesh->vertices[m_mesh->indices[3 * triangle + i]].position, 1.0f));
  };
  return {at(0), at(1), at(2)};
}

/// m^2; 0 for one that can't be used.
double MeshArea::areaOf(std::size_t triangle) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (m_mesh->indices[3 * triangle + i] >= m_mesh->vertices.size()) return 0;
  }
  const Corners at = corners(triangle);
  if (!usable(at.a) || !usable(at.b) || !usable(at.c)) return 0;
  const glm::vec3 across = glm::cross(at.b - at.a, at.c - at.a);
  const double twice = glm::length(glm::dvec3(across));
  // Too thin to have a direction: nothing can stand up from it.
  return std::isfinite(twice) && twice > 1e-20 ? 0.5 * twice : 0;
}

void MeshArea::findNeighbours() {
  struct Edge {
    std::uint64_t ends;
    std::uint32_t place;
  };
  const std::vector<std::uint32_t> first = welded(m_mesh->vertices);
  std::vector<Edge> edges;
  edges.reserve(3 * triangles());
  for (std::size_t t = 0; t < triangles(); ++t) {
    if (m_sums[t] == (t > 0 ? m_sums[t - 1] : 0.0)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = first[m_mesh->indices[3 * t + i]], b = first[m_mesh->indices[3 * t + (i + 1) % 3]];
      edges.push_back(
          {static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b), static_cast<std::uint32_t>(3 * t + i)});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.ends != b.ends ? a.ends < b.ends : a.place < b.place; });
  m_neighbours.assign(3 * triangles(), kNone);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].ends == edges[i].ends) ++end;
    // Where more than two meet there is no straight on.
    if (end - i == 2) {
      m_neighbours[edges[i].place] = edges[i + 1].place;
      m_neighbours[edges[i + 1].place] = edges[i].place;
    }
    i = end;
  }
}

/// `part`: of the ways from the first corner to the second and to the third.
GrowthPoint MeshArea::pointIn(std::size_t triangle, glm::vec2 part, bool back) const {
  const Corners at = corners(triangle);
  GrowthPoint point;
  point.place = at.a + (at.b - at.a) * part.x + (at.c - at.a) * part.y;
  const auto normal = [&](std::size_t i) { return m_mesh->vertices[m_mesh->indices[3 * triangle + i]].normal; };
  const glm::vec3 mixed = normal(0) * (1.0f - part.x - part.y) + normal(1) * part.x + normal(2) * part.y;
  glm::vec3 up = glm::mat3(m_pose) * mixed;
  const float length = glm::length(mixed);
  if (!(length > 0.05f && length < 20.0f) || !usable(up)) up = glm::cross(at.b - at.a, at.c - at.a);
  up = glm::vec3(glm::normalize(glm::dvec3(up)));
  point.up = back ? -up : up;
  point.cell = static_cast<std::uint32_t>(triangle);
  point.back = back;
  return point;
}

GrowthPoint MeshArea::at(int, double along, RandomStream& random) const {
  const double side = along * m_sides;
  const bool back = side >= 1.0;
  const double target = (side - (back ? 1.0 : 0.0)) * m_oneSide;
  auto found = std::upper_bound(m_sums.begin(), m_sums.end(), target);
  // Rounding at the very end: the last triangle that has an area.
  if (found == m_sums.end()) found = std::lower_bound(m_sums.begin(), m_sums.end(), m_oneSide);
  glm::vec2 part(random.next(), 0.0f);
  part.y = random.next();
  if (part.x + part.y > 1.0f) part = 1.0f - part;
  return pointIn(static_cast<std::size_t>(found - m_sums.begin()), part, back);
}

/// Walks along `way` within the triangle, and on to the next one where it ends. False: all of the way is done, or the
/// mesh ends here.
bool MeshArea::step(std::size_t& triangle, glm::vec3& place, glm::vec3& way, bool& back) const {
  const Corners at = corners(triangle);
  const glm::vec3 p[3] = {at.a, at.b, at.c};
  const glm::vec3 normal = glm::normalize(glm::cross(at.b - at.a, at.c - at.a));
  const float length = glm::length(way);
  const glm::vec3 flat = way - normal * glm::dot(way, normal);
  const float flatLength = glm::length(flat);
  if (!(flatLength > 1e-3f * length)) return false;
  way = flat * (length / flatLength);
  float part = 1.0f;
  int exit = -1;
  for (int i = 0; i < 3; ++i) {
    const glm::vec3 inwards = glm::cross(normal, p[(i + 1) % 3] - p[i]);
    const float speed = glm::dot(way, inwards);
    if (speed >= 0.0f) continue;
    const float t = std::max(glm::dot(place - p[i], inwards), 0.0f) / -speed;
    if (t >= part) continue;
    part = t;
    exit = i;
  }
  place += way * part;
  if (exit < 0) return false;
  const std::uint32_t next = m_neighbours[3 * triangle + static_cast<std::size_t>(exit)];
  if (next == kNone) return false;
  way *= 1.0f - part;
  // Turned about the edge into the next triangle's plane.
  const glm::vec3 edge = glm::normalize(p[(exit + 1) % 3] - p[exit]);
  const float with = glm::dot(way, edge);
  const float over = std::sqrt(std::max(glm::dot(way, way) - with * with, 0.0f));
  triangle = next / 3;
  const Corners on = corners(triangle);
  const glm::vec3 q[3] = {on.a, on.b, on.c};
  const std::size_t entry = next % 3;
  const glm::vec3 along = q[(entry + 1) % 3] - q[entry];
  const glm::vec3 inwards = glm::cross(glm::cross(on.b - on.a, on.c - on.a), along);
  way = edge * with + glm::normalize(inwards) * over;
  // Neighbours that run along their edge in one direction look to different sides.
  if (glm::dot(along, edge) > 0.0f) back = !back;
  return true;
}

std::optional<GrowthPoint> MeshArea::beside(int, const GrowthPoint& from, glm::vec3 offset, RandomStream&) const {
  std::size_t triangle = from.cell;
  glm::vec3 place = from.place;
  bool back = from.back;
  for (int i = 0; i < kMostSteps && step(triangle, place, offset, back); ++i) {
  }
  const Corners at = corners(triangle);
  const glm::dvec3 u(at.b - at.a), v(at.c - at.a), w(place - at.a);
  const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), uw = glm::dot(u, w), vw = glm::dot(v, w);
  const double area = uu * vv - uv * uv;
  if (!(area > 0)) return std::nullopt;
  glm::vec2 part(glm::dvec2(uw * vv - vw * uv, vw * uu - uw * uv) / area);
  part = glm::max(part, glm::vec2(0.0f));
  if (const float sum = part.x + part.y; sum > 1.0f) part /= sum;
  return pointIn(triangle, part, back);
}

}  // namespace windloom
