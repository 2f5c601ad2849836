#include "engine/model/surface_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "engine/model/hare_shape.hpp"
#include "engine/model/surface_nets.hpp"

namespace windloom {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

PlantVertex vertexAt(glm::dvec3 position, glm::dvec3 normal, glm::dvec2 uv) {
  return {.position = glm::vec3(position), .normal = glm::vec3(glm::normalize(normal)), .uv = glm::vec2(uv)};
}

/// A closed tube: `rows` rings of `around` vertices; the last ring joins the first one turned by `shift` vertices.
PlantMesh tube(int rows, int around, int shift, const std::function<PlantVertex(int, int)>& at) {
  PlantMesh mesh;
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < around; ++k) mesh.vertices.push_back(at(i, k));
  }
  const auto index = [&](int i, int k) {
    const int turned = i == rows ? k + shift : k;
    return static_cast<std::uint32_t>((i % rows) * around + turned % around);
  };
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < around; ++k) {
      for (const std::uint32_t one :
           {index(i, k), index(i, k + 1), index(i + 1, k + 1), index(i, k), index(i + 1, k + 1), index(i + 1, k)})
        mesh.indices.push_back(one);
    }
  }
  return mesh;
}

PlantMesh torus() {
  constexpr int kRows = 128, kAround = 56;
  constexpr double kRing = 0.35, kTube = 0.15;
  return tube(kRows, kAround, 0, [](int i, int k) {
    const double u = kTurn * i / kRows, v = kTurn * k / kAround;
    const glm::dvec3 out(std::cos(u), 0.0, std::sin(u));
    const glm::dvec3 normal = out * std::cos(v) + glm::dvec3(0.0, std::sin(v), 0.0);
    return vertexAt(out * kRing + normal * kTube, normal, {u / kTurn, v / kTurn});
  });
}

struct ProfilePoint {
  glm::dvec2 place, normal;
};

/// A flat strip's cross-section with round edges, counter-clockwise, half of which is the other half turned by half a
/// turn.
std::vector<ProfilePoint> stripProfile(double halfWidth, double halfThickness, int across, int edge) {
  std::vector<ProfilePoint> half;
  const double flat = halfWidth - halfThickness;
  for (int k = 0; k < edge; ++k) {
    const double angle = kTurn * (static_cast<double>(k) / edge - 0.5) * 0.5;
    const glm::dvec2 out(std::cos(angle), std::sin(angle));
    half.push_back({glm::dvec2(flat, 0.0) + out * halfThickness, out});
  }
  for (int k = 0; k < across; ++k) half.push_back({{flat * (1.0 - 2.0 * k / across), halfThickness}, {0.0, 1.0}});
  std::vector<ProfilePoint> profile = half;
  for (const ProfilePoint& point : half) profile.push_back({-point.place, -point.normal});
  return profile;
}

/// A band of some thickness, so that it is a solid and all of its one side is outside.
PlantMesh moebius() {
  constexpr int kRows = 216;
  constexpr double kRing = 0.34, kHalfWidth = 0.16, kHalfThickness = 0.011;
  const std::vector<ProfilePoint> profile = stripProfile(kHalfWidth, kHalfThickness, 16, 6);
  const int around = static_cast<int>(profile.size());
  return tube(kRows, around, around / 2, [&](int i, int k) {
    const auto& [place, normal] = profile[static_cast<std::size_t>(k)];
    const double u = kTurn * i / kRows, c = std::cos(0.5 * u), s = std::sin(0.5 * u);
    const glm::dvec3 out(std::cos(u), 0.0, std::sin(u)), up(0.0, 1.0, 0.0), on(-std::sin(u), 0.0, std::cos(u));
    const glm::dvec3 x = c * out + s * up, y = c * up - s * out;
    const glm::dvec3 from = place.x * x + place.y * y;
    // Along the band: the ring's circle, and the twist, half a turn a round.
    const double reach = kRing + glm::dot(from, out);
    const glm::dvec3 along = on * reach + 0.5 * (place.x * y - place.y * x);
    const glm::dvec3 across = normal.x * y - normal.y * x;
    glm::dvec3 facing = glm::cross(along, across);
    if (glm::dot(facing, normal.x * x + normal.y * y) < 0.0) facing = -facing;
    return vertexAt(out * kRing + from, facing, {u / kTurn, static_cast<double>(k) / around});
  });
}

/// An icosahedron whose triangles are cut in four again and again.
PlantMesh sphere() {
  constexpr int kCuts = 4;
  const double g = std::numbers::phi;
  std::vector<glm::dvec3> places;
  for (const double one : {-1.0, 1.0}) {
    for (const double other : {-g, g}) {
      for (const glm::dvec3 corner : {glm::dvec3(0, one, other), glm::dvec3(one, other, 0), glm::dvec3(other, 0, one)})
        places.push_back(glm::normalize(corner));
    }
  }
  std::vector<std::uint32_t> indices;
  const double side = 2.0 / std::sqrt(1.0 + g * g) * 1.01;
  for (std::uint32_t a = 0; a < 12; ++a) {
    for (std::uint32_t b = a + 1; b < 12; ++b) {
      for (std::uint32_t c = b + 1; c < 12; ++c) {
        const glm::dvec3 p = places[a], q = places[b], r = places[c];
        if (glm::distance(p, q) > side || glm::distance(q, r) > side || glm::distance(p, r) > side) continue;
        const bool outwards = glm::dot(glm::cross(q - p, r - p), p) > 0.0;
        indices.insert(indices.end(), {a, outwards ? b : c, outwards ? c : b});
      }
    }
  }
  for (int cut = 0; cut < kCuts; ++cut) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, made] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(places.size()));
      if (made) places.push_back(glm::normalize(places[a] + places[b]));
      return found->second;
    };
    std::vector<std::uint32_t> finer;
    for (std::size_t t = 0; t < indices.size(); t += 3) {
      const std::uint32_t a = indices[t], b = indices[t + 1], c = indices[t + 2];
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
    }
    indices = std::move(finer);
  }
  PlantMesh mesh;
  for (const glm::dvec3 p : places)
    mesh.vertices.push_back(vertexAt(0.5 * p, p, {0.5 + std::atan2(p.z, p.x) / kTurn, std::acos(p.y) / (0.5 * kTurn)}));
  mesh.indices = std::move(indices);
  return mesh;
}

PlantMesh hare() {
  constexpr double kCell = 0.0137;  // gives a little less than kMaxPlantTriangles
  return meshOfField(hareField, {-0.48, -0.05, -0.32}, {0.42, 1.12, 0.32}, kCell);
}

/// Triangles' corners run counter-clockwise seen from outside: as the normals say.
void turnOutwards(PlantMesh& mesh) {
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const PlantVertex &a = mesh.vertices[mesh.indices[t]], &b = mesh.vertices[mesh.indices[t + 1]],
                      &c = mesh.vertices[mesh.indices[t + 2]];
    const glm::vec3 facing = glm::cross(b.position - a.position, c.position - a.position);
    if (glm::dot(facing, a.normal + b.normal + c.normal) < 0.0f) std::swap(mesh.indices[t + 1], mesh.indices[t + 2]);
  }
}

void setBounds(PlantMesh& mesh) {
  mesh.low = mesh.high = mesh.vertices.front().position;
  for (const PlantVertex& vertex : mesh.vertices) {
    mesh.low = glm::min(mesh.low, vertex.position);
    mesh.high = glm::max(mesh.high, vertex.position);
  }
}

/// To the size and place that the header promises.
void settle(PlantMesh& mesh) {
  setBounds(mesh);
  const glm::vec3 size = mesh.high - mesh.low;
  const glm::vec3 foot(0.5f * (mesh.low.x + mesh.high.x), mesh.low.y, 0.5f * (mesh.low.z + mesh.high.z));
  const float scale = 1.0f / std::max({size.x, size.y, size.z});
  for (PlantVertex& vertex : mesh.vertices) vertex.position = (vertex.position - foot) * scale;
  setBounds(mesh);
}

}  // namespace

PlantMesh makeSurfaceMesh(SurfaceShape shape) {
  PlantMesh mesh;
  switch (shape) {
    case SurfaceShape::Moebius:
      mesh = moebius();
      break;
    case SurfaceShape::Torus:
      mesh = torus();
      break;
    case SurfaceShape::Sphere:
      mesh = sphere();
      break;
    case SurfaceShape::Hare:
      mesh = hare();
      break;
    case SurfaceShape::Mesh:
      return mesh;
  }
  turnOutwards(mesh);
  settle(mesh);
  return mesh;
}

std::shared_ptr<const PlantMesh> surfaceMesh(const Surface& surface) {
  const auto make = [](SurfaceShape shape) { return std::make_shared<const PlantMesh>(makeSurfaceMesh(shape)); };
  switch (surface.shape) {
    case SurfaceShape::Moebius: {
      static const auto mesh = make(SurfaceShape::Moebius);
      return mesh;
    }
    case SurfaceShape::Torus: {
      static const auto mesh = make(SurfaceShape::Torus);
      return mesh;
    }
    case SurfaceShape::Sphere: {
      static const auto mesh = make(SurfaceShape::Sphere);
      return mesh;
    }
    case SurfaceShape::Hare: {
      static const auto mesh = make(SurfaceShape::Hare);
      return mesh;
    }
    case SurfaceShape::Mesh:
      break;
  }
  return surface.mesh;
}

}  // namespace windloom
