#include "engine/model/sphere_packing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace windloom {
namespace {

constexpr int kVoxels = 40;  // along the longest side, for kUsualSpheres and less
constexpr int kFewestVoxels = 4;
constexpr float kEnoughCovered = 0.985f;

/// Voxels of a box around the mesh, with an empty rim of one.
struct Voxels {
  glm::ivec3 count{0};
  glm::vec3 low{0.0f};
  float side = 1.0f;
  std::vector<std::uint8_t> inside;

  [[nodiscard]] std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count.y) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(count.x) +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] glm::vec3 centre(int x, int y, int z) const { return low + (glm::vec3(x, y, z) + 0.5f) * side; }
  [[nodiscard]] glm::ivec3 place(std::size_t index) const {
    const auto x = static_cast<std::size_t>(count.x), y = static_cast<std::size_t>(count.y);
    return {index % x, index / x % y, index / (x * y)};
  }
};

/// Along the longest side: finer for more spheres, so that a long thin mesh has room for them.
int voxelsFor(std::size_t most) {
  const double more = static_cast<double>(std::max(most, kUsualSpheres)) / static_cast<double>(kUsualSpheres);
  return static_cast<int>(std::lround(kVoxels * std::pow(more, 0.9)));
}

Voxels boxAround(const PlantMesh& mesh, int along) {
  glm::vec3 low = mesh.vertices[mesh.indices.front()].position, high = low;
  for (const std::uint32_t index : mesh.indices) {
    low = glm::min(low, mesh.vertices[index].position);
    high = glm::max(high, mesh.vertices[index].position);
  }
  const glm::vec3 size = high - low;
  Voxels voxels;
  voxels.side = std::max(std::max({size.x, size.y, size.z}) / static_cast<float>(along), 1e-6f);
  voxels.count = glm::ivec3(glm::ceil(size / voxels.side - 1e-3f)) + 2;
  voxels.count = glm::max(voxels.count, glm::ivec3(3));
  voxels.low = 0.5f * (low + high) - 0.5f * voxels.side * glm::vec3(voxels.count);
  voxels.inside.assign(voxels.at(0, 0, voxels.count.z), 0);
  return voxels;
}

/// Into how many steps markSurface cuts the sides of a triangle.
int surfaceSteps(const Voxels& voxels, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  const float longest = std::max({glm::length(b - a), glm::length(c - a), glm::length(c - b)});
  return std::clamp(static_cast<int>(std::ceil(2.0f * longest / voxels.side)), 1,
                    4 * glm::max(voxels.count.x, glm::max(voxels.count.y, voxels.count.z)));
}

/// How many rays vote() asks for along all three axes, and points markSurface() marks.
double packingWork(const PlantMesh& mesh, const Voxels& voxels) {
  double work = 0;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const glm::vec3 a = mesh.vertices[mesh.indices[t]].position, b = mesh.vertices[mesh.indices[t + 1]].position,
                    c = mesh.vertices[mesh.indices[t + 2]].position;
    const glm::vec3 over = (glm::max(a, glm::max(b, c)) - glm::min(a, glm::min(b, c))) / voxels.side + 1.0f;
    const int steps = surfaceSteps(voxels, a, b, c);
    work += static_cast<double>(over.x * over.y + over.y * over.z + over.z * over.x) + 0.5 * (steps + 1) * (steps + 2);
  }
  return work;
}

/// For each voxel whether the rays along `axis`, coming from the voxel before it, cross the mesh an odd number of times
/// until its centre.
std::vector<std::uint8_t> crossings(const PlantMesh& mesh, const Voxels& voxels, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<std::uint8_t> odd(voxels.inside.size(), 0);
  // A little aside, so that rays miss the edges that modellers put on round coordinates.
  const double aside = 1.2345e-3;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    glm::dvec3 p[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3 place = (mesh.vertices[mesh.indices[t + i]].position - voxels.low) / voxels.side;
      p[i] = {static_cast<double>(place[u]) - 0.5 - aside, static_cast<double>(place[v]) - 0.5 - 0.7 * aside,
              static_cast<double>(place[axis])};
    }
    const double area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (p[1].y - p[0].y);
    if (std::abs(area) < 1e-12) continue;
    const auto bound = [&](int c, int last, int& from, int& to) {
      from = std::max(0, static_cast<int>(std::ceil(std::min({p[0][c], p[1][c], p[2][c]}))));
      to = std::min(last, static_cast<int>(std::floor(std::max({p[0][c], p[1][c], p[2][c]}))));
    };
    int x0, x1, y0, y1;
    bound(0, voxels.count[u] - 1, x0, x1);
    bound(1, voxels.count[v] - 1, y0, y1);
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        const double b = ((x - p[0].x) * (p[2].y - p[0].y) - (p[2].x - p[0].x) * (y - p[0].y)) / area;
        const double c = ((p[1].x - p[0].x) * (y - p[0].y) - (x - p[0].x) * (p[1].y - p[0].y)) / area;
        if (b < 0 || c < 0 || b + c >= 1) continue;
        const auto crossed = static_cast<float>(p[0].z + b * (p[1].z - p[0].z) + c * (p[2].z - p[0].z));
        // The first voxel whose centre lies beyond.
        const double first = std::max(0.0, std::floor(static_cast<double>(crossed) - 0.5) + 1.0);
        if (first >= voxels.count[axis]) continue;
        glm::ivec3 place;
        place[axis] = static_cast<int>(first);
        place[u] = x;
        place[v] = y;
        odd[voxels.at(place.x, place.y, place.z)] ^= 1;
      }
    }
  }
  return odd;
}

/// One vote for every voxel that an odd number of crossings lies before.
void vote(const PlantMesh& mesh, Voxels& voxels, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const std::vector<std::uint8_t> odd = crossings(mesh, voxels, axis);
  glm::ivec3 place;
  for (place[v] = 0; place[v] < voxels.count[v]; ++place[v]) {
    for (place[u] = 0; place[u] < voxels.count[u]; ++place[u]) {
      bool inside = false;
      for (place[axis] = 0; place[axis] < voxels.count[axis]; ++place[axis]) {
        const std::size_t i = voxels.at(place.x, place.y, place.z);
        if (odd[i] != 0) inside = !inside;
        if (inside) ++voxels.inside[i];
      }
    }
  }
}

/// Marks the voxels around points spread over every triangle.
void markSurface(const PlantMesh& mesh, Voxels& voxels) {
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const glm::vec3 a = mesh.vertices[mesh.indices[t]].position, b = mesh.vertices[mesh.indices[t + 1]].position,
                    c = mesh.vertices[mesh.indices[t + 2]].position;
    const int steps = surfaceSteps(voxels, a, b, c);
    for (int i = 0; i <= steps; ++i) {
      for (int k = 0; i + k <= steps; ++k) {
        const glm::vec2 part = glm::vec2(i, k) / static_cast<float>(steps);
        const glm::vec3 point = a + (b - a) * part.x + (c - a) * part.y;
        // Rounded to zero, which is downwards where it isn't clamped.
        const glm::ivec3 place =
            glm::clamp(glm::ivec3((point - voxels.low) / voxels.side), glm::ivec3(1), voxels.count - 2);
        voxels.inside[voxels.at(place.x, place.y, place.z)] = 1;
      }
    }
  }
}

Voxels voxelise(const PlantMesh& mesh, int along) {
  Voxels voxels = boxAround(mesh, along);
  constexpr auto kMost = static_cast<double>(kMostPackingWork);
  for (double work = packingWork(mesh, voxels); work > kMost && along > kFewestVoxels;
       work = packingWork(mesh, voxels)) {
    along = std::clamp(static_cast<int>(along * std::sqrt(kMost / work)), kFewestVoxels, along - 1);
    voxels = boxAround(mesh, along);
  }
  for (int axis = 0; axis < 3; ++axis) vote(mesh, voxels, axis);
  for (std::uint8_t& votes : voxels.inside) votes = votes >= 2 ? 1 : 0;
  // Next to nothing inside of what is many voxels large: no closed surface.
  const auto filled = std::ranges::count(voxels.inside, std::uint8_t{1});
  if (filled < along) {
    std::ranges::fill(voxels.inside, std::uint8_t{0});
    markSurface(mesh, voxels);
  }
  return voxels;
}

/// One pass of the exact distance transform (Felzenszwalb & Huttenlocher, "Distance Transforms of Sampled Functions",
/// 2012) along a line of squared distances.
void transformLine(std::vector<float>& line, std::vector<int>& hull, std::vector<float>& bounds) {
  const int n = static_cast<int>(line.size());
  const std::vector<float> from = line;
  const auto meet = [&](int a, int b) {
    const auto fa = static_cast<double>(from[static_cast<std::size_t>(a)]) + static_cast<double>(a) * a;
    const auto fb = static_cast<double>(from[static_cast<std::size_t>(b)]) + static_cast<double>(b) * b;
    return static_cast<float>((fb - fa) / (2.0 * (b - a)));
  };
  int last = 0;
  hull[0] = 0;
  bounds[0] = -std::numeric_limits<float>::infinity();
  for (int q = 1; q < n; ++q) {
    float s = meet(hull[static_cast<std::size_t>(last)], q);
    while (s <= bounds[static_cast<std::size_t>(last)]) s = meet(hull[static_cast<std::size_t>(--last)], q);
    hull[static_cast<std::size_t>(++last)] = q;
    bounds[static_cast<std::size_t>(last)] = s;
  }
  int k = 0;
  for (int q = 0; q < n; ++q) {
    while (k < last && bounds[static_cast<std::size_t>(k + 1)] < static_cast<float>(q)) ++k;
    const int p = hull[static_cast<std::size_t>(k)];
    line[static_cast<std::size_t>(q)] = static_cast<float>((q - p) * (q - p)) + from[static_cast<std::size_t>(p)];
  }
}

/// Squared distance of each voxel's centre to the nearest one outside, in voxels.
std::vector<float> distancesOutwards(const Voxels& voxels) {
  std::vector<float> squares(voxels.inside.size());
  for (std::size_t i = 0; i < squares.size(); ++i) squares[i] = voxels.inside[i] != 0 ? 1e9f : 0.0f;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto length = static_cast<std::size_t>(voxels.count[axis]);
    std::vector<float> line(length), bounds(length + 1);
    std::vector<int> hull(length + 1);
    glm::ivec3 place;
    for (place[v] = 0; place[v] < voxels.count[v]; ++place[v]) {
      for (place[u] = 0; place[u] < voxels.count[u]; ++place[u]) {
        for (place[axis] = 0; place[axis] < voxels.count[axis]; ++place[axis])
          line[static_cast<std::size_t>(place[axis])] = squares[voxels.at(place.x, place.y, place.z)];
        transformLine(line, hull, bounds);
        for (place[axis] = 0; place[axis] < voxels.count[axis]; ++place[axis])
          squares[voxels.at(place.x, place.y, place.z)] = line[static_cast<std::size_t>(place[axis])];
      }
    }
  }
  return squares;
}

/// Marks the voxels whose centres a sphere holds; how many are new.
std::size_t cover(const Voxels& voxels, glm::ivec3 centre, float radius, std::vector<std::uint8_t>& covered) {
  std::size_t added = 0;
  const int reach = static_cast<int>(std::ceil(radius));
  const glm::ivec3 low = glm::max(centre - reach, glm::ivec3(0)), high = glm::min(centre + reach, voxels.count - 1);
  for (int z = low.z; z <= high.z; ++z) {
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        const glm::vec3 away(glm::ivec3(x, y, z) - centre);
        const std::size_t i = voxels.at(x, y, z);
        if (glm::dot(away, away) > radius * radius || voxels.inside[i] == 0 || covered[i] != 0) continue;
        covered[i] = 1;
        ++added;
      }
    }
  }
  return added;
}

}  // namespace

std::vector<glm::vec4> packSpheres(const PlantMesh& mesh, std::size_t most) {
  std::vector<glm::vec4> spheres;
  if (mesh.indices.size() < 3) return spheres;
  most = std::clamp<std::size_t>(most, 1, kMaxSpheres);
  const Voxels voxels = voxelise(mesh, voxelsFor(most));
  const std::vector<float> squares = distancesOutwards(voxels);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (voxels.inside[i] != 0) order.push_back(i);
  }
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return squares[a] > squares[b]; });
  std::vector<std::uint8_t> covered(voxels.inside.size(), 0);
  const auto enough = static_cast<std::size_t>(kEnoughCovered * static_cast<float>(order.size()));
  std::size_t done = 0;
  for (const std::size_t i : order) {
    if (spheres.size() == most || done >= enough) break;
    if (covered[i] != 0) continue;
    const glm::ivec3 place = voxels.place(i);
    // The surface runs about half a voxel before the first centre outside.
    const float radius = std::sqrt(squares[i]);
    done += cover(voxels, place, radius, covered);
    spheres.emplace_back(voxels.centre(place.x, place.y, place.z), radius * voxels.side);
  }
  return spheres;
}

std::shared_ptr<const PlantMesh> packedWith(std::shared_ptr<const PlantMesh> mesh, int most) {
  const std::size_t wanted = static_cast<std::size_t>(std::clamp(most, 1, static_cast<int>(kMaxSpheres)));
  if (!mesh || mesh->mostSpheres == wanted) return mesh;
  auto packed = std::make_shared<PlantMesh>(*mesh);
  packed->spheres = packSpheres(*packed, wanted);
  packed->mostSpheres = wanted;
  return packed;
}

}  // namespace windloom
