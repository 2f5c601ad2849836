#include "engine/grass/poisson_disk.hpp"

#include <bit>

namespace windloom {
namespace {

/// Places in cubes of twice the least distance; cubes share a slot where their hashes do, which only costs time.
class HashGrid {
 public:
  HashGrid(const std::vector<GrowthPoint>& points, float least)
      : m_points(points),
        m_least(least),
        m_heads(std::bit_ceil(points.size() + 1), kEnd),
        m_next(points.size(), kEnd) {}

  [[nodiscard]] bool free(const GrowthPoint& point) const {
    // At most two cubes along each axis.
    const glm::ivec3 low = cubeOf(point.place - m_least), high = cubeOf(point.place + m_least);
    for (int z = low.z; z <= high.z; ++z) {
      for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
          for (std::uint32_t i = m_heads[slotOf({x, y, z})]; i != kEnd; i = m_next[i]) {
            const glm::vec3 away = m_points[i].place - point.place;
            if (glm::dot(away, away) < m_least * m_least && glm::dot(m_points[i].up, point.up) > 0.0f) return false;
          }
        }
      }
    }
    return true;
  }

  void add(std::size_t i) {
    std::uint32_t& head = m_heads[slotOf(cubeOf(m_points[i].place))];
    m_next[i] = head;
    head = static_cast<std::uint32_t>(i);
  }

 private:
  static constexpr std::uint32_t kEnd = ~0u;

  [[nodiscard]] glm::ivec3 cubeOf(glm::vec3 place) const {
    return glm::ivec3(glm::clamp(glm::floor(place / (2.0f * m_least)), glm::vec3(-1e9f), glm::vec3(1e9f)));
  }
  [[nodiscard]] std::size_t slotOf(glm::ivec3 cube) const {
    const auto bits = [](int i) { return static_cast<std::uint32_t>(i); };
    return hashCombine(bits(cube.x) * 0x8da6b343u ^ bits(cube.z) * 0xd8163841u, bits(cube.y)) & (m_heads.size() - 1);
  }

  const std::vector<GrowthPoint>& m_points;
  float m_least;
  std::vector<std::uint32_t> m_heads, m_next;
};

}  // namespace

std::vector<std::size_t> poissonDisk(const std::vector<GrowthPoint>& candidates, float least,
                                     const std::atomic<bool>* cancelled) {
  HashGrid grid(candidates, least);
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i % 4096 == 0 && cancelled != nullptr && cancelled->load()) return {};
    if (!grid.free(candidates[i])) continue;
    grid.add(i);
    taken.push_back(i);
  }
  return taken;
}

}  // namespace windloom
