// Gibson, "Constrained elastic surface nets", 1998, in the form where a cube's vertex is the mean of the crossings on
// its edges; then a few Newton steps pull it onto the surface.
#include "engine/model/surface_nets.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

constexpr int kPullSteps = 4;

class Net {
 public:
  Net(const ImplicitField& field, glm::dvec3 low, glm::dvec3 high, double cell)
      : m_field(field), m_low(low), m_cell(cell), m_count(glm::ivec3(glm::ceil((high - low) / cell)) + 1) {
    m_values.resize(at(0, 0, m_count.z));
    for (int z = 0; z < m_count.z; ++z) {
      for (int y = 0; y < m_count.y; ++y) {
        for (int x = 0; x < m_count.x; ++x) m_values[at(x, y, z)] = field(place(glm::dvec3(x, y, z)));
      }
    }
    m_vertex.assign(m_values.size(), 0);
  }

  PlantMesh mesh() {
    for (int z = 0; z + 1 < m_count.z; ++z) {
      for (int y = 0; y + 1 < m_count.y; ++y) {
        for (int x = 0; x + 1 < m_count.x; ++x) addVertex({x, y, z});
      }
    }
    for (int axis = 0; axis < 3; ++axis) addQuads(axis);
    return std::move(m_mesh);
  }

 private:
  [[nodiscard]] std::size_t at(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(m_count.y) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(m_count.x) +
           static_cast<std::size_t>(x);
  }
  [[nodiscard]] std::size_t at(glm::ivec3 p) const { return at(p.x, p.y, p.z); }
  [[nodiscard]] glm::dvec3 place(glm::dvec3 p) const { return m_low + p * m_cell; }

  [[nodiscard]] glm::dvec3 gradient(glm::dvec3 p) const {
    const double h = 0.25 * m_cell;
    glm::dvec3 slope;
    for (int c = 0; c < 3; ++c) {
      glm::dvec3 step(0.0);
      step[c] = h;
      slope[c] = (m_field(p + step) - m_field(p - step)) / (2.0 * h);
    }
    return slope;
  }

  /// Onto the surface, but not out of its cube, so that the net doesn't fold.
  [[nodiscard]] glm::dvec3 pulled(glm::dvec3 p, glm::ivec3 cube) const {
    const glm::dvec3 low = place(glm::dvec3(cube)), high = low + m_cell;
    for (int i = 0; i < kPullSteps; ++i) {
      const glm::dvec3 slope = gradient(p);
      const double steep = glm::dot(slope, slope);
      if (steep < 1e-9) break;
      p = glm::clamp(p - slope * (m_field(p) / steep), low, high);
    }
    return p;
  }

  void addVertex(glm::ivec3 cube) {
    glm::dvec3 sum(0.0);
    int crossings = 0;
    for (int axis = 0; axis < 3; ++axis) {
      for (int side = 0; side < 4; ++side) {
        glm::ivec3 a(0);
        a[(axis + 1) % 3] = side & 1;
        a[(axis + 2) % 3] = side >> 1;
        glm::ivec3 b = a;
        b[axis] = 1;
        const double from = m_values[at(cube + a)], to = m_values[at(cube + b)];
        if ((from < 0.0) == (to < 0.0)) continue;
        sum += glm::mix(glm::dvec3(a), glm::dvec3(b), from / (from - to));
        ++crossings;
      }
    }
    if (crossings == 0) return;
    const glm::dvec3 p = pulled(place(glm::dvec3(cube) + sum / static_cast<double>(crossings)), cube);
    m_vertex[at(cube)] = static_cast<std::uint32_t>(m_mesh.vertices.size());
    m_mesh.vertices.push_back({.position = glm::vec3(p),
                               .normal = glm::vec3(glm::normalize(gradient(p))),
                               .uv = {},
                               .colour = glm::vec4(1.0f)});
  }

  /// One quad around every grid edge along `axis` that crosses the surface.
  void addQuads(int axis) {
    glm::ivec3 u(0), v(0), along(0);
    along[axis] = u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1;
    glm::ivec3 p;
    for (p.z = 1 - along.z; p.z + 1 < m_count.z; ++p.z) {
      for (p.y = 1 - along.y; p.y + 1 < m_count.y; ++p.y) {
        for (p.x = 1 - along.x; p.x + 1 < m_count.x; ++p.x) {
          const bool in = m_values[at(p)] < 0.0;
          if (in == (m_values[at(p + along)] < 0.0)) continue;
          const std::uint32_t q[4] = {m_vertex[at(p - u - v)], m_vertex[at(p - v)], m_vertex[at(p)],
                                      m_vertex[at(p - u)]};
          addQuad(q, in);
        }
      }
    }
  }

  /// Cut along the shorter diagonal.
  void addQuad(const std::uint32_t (&q)[4], bool outwards) {
    const auto distance = [&](int a, int b) {
      return glm::distance(m_mesh.vertices[q[a]].position, m_mesh.vertices[q[b]].position);
    };
    const int first = distance(0, 2) <= distance(1, 3) ? 0 : 1;
    for (const int second : {1, 2}) {
      std::uint32_t triangle[3] = {q[first], q[(first + second) % 4], q[(first + second + 1) % 4]};
      if (!outwards) std::swap(triangle[1], triangle[2]);
      m_mesh.indices.insert(m_mesh.indices.end(), triangle, triangle + 3);
    }
  }

  const ImplicitField& m_field;
  glm::dvec3 m_low;
  double m_cell;
  glm::ivec3 m_count;  // samples
  std::vector<double> m_values;
  std::vector<std::uint32_t> m_vertex;  // of each cube, by its lowest sample
  PlantMesh m_mesh;
};

}  // namespace

PlantMesh meshOfField(const ImplicitField& field, glm::dvec3 low, glm::dvec3 high, double cell) {
  return Net(field, low, high, cell).mesh();
}

}  // namespace windloom
