#include "engine/grass/shell_clumps.hpp"

#include <algorithm>
#include <cmath>

#include "engine/grass/growth_area.hpp"

namespace windloom {
namespace {

constexpr float kClumpM = 0.75f;  // as in the instanced grass
constexpr int kMostCells = 40;    // a side; in larger squares clumps are larger

/// Even numbers 0..1 for the cells of a square that wraps around, little alike in neighbours: the highest goes to where
/// the ones nearby are lowest, then the lowest to where they are highest, and so on to the middle.
std::vector<float> unlikeNeighbours(int cells, std::uint32_t seed) {
  const auto count = static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells);
  RandomStream random(seed);
  std::vector<float> values(count, 0.5f), nearby(count);
  if (count == 1) return {random.next()};
  // Chance decides where there is nothing yet.
  for (float& mean : nearby) mean = 1e-3f * random.next();
  std::vector<bool> taken(count, false);
  for (std::size_t n = 0; n < count; ++n) {
    const float sign = n % 2 == 0 ? 1.0f : -1.0f;
    const float excess = sign * (0.5f - (static_cast<float>(n / 2) + 0.5f) / static_cast<float>(count));
    std::size_t best = count;
    for (std::size_t i = 0; i < count; ++i) {
      if (!taken[i] && (best == count || sign * nearby[i] < sign * nearby[best])) best = i;
    }
    taken[best] = true;
    values[best] = 0.5f + excess;
    const int x = static_cast<int>(best) % cells, y = static_cast<int>(best) / cells;
    for (int v = -3; v <= 3; ++v) {
      for (int u = -3; u <= 3; ++u) {
        const int to = (y + v + 3 * cells) % cells * cells + (x + u + 3 * cells) % cells;
        nearby[static_cast<std::size_t>(to)] += excess * std::exp(-0.35f * static_cast<float>(u * u + v * v));
      }
    }
  }
  return values;
}

}  // namespace

ShellClumps::ShellClumps(float sideM, std::uint32_t seed)
    : m_cells(std::clamp(static_cast<int>(std::lround(sideM / kClumpM)), 1, kMostCells)) {
  const std::vector<float> size = unlikeNeighbours(m_cells, hashCombine(seed, 1)),
                           dry = unlikeNeighbours(m_cells, hashCombine(seed, 2)),
                           bright = unlikeNeighbours(m_cells, hashCombine(seed, 3)),
                           hue = unlikeNeighbours(m_cells, hashCombine(seed, 4));
  RandomStream random(hashCombine(seed, 5));
  for (std::size_t i = 0; i < size.size(); ++i) {
    const float x = random.next(), y = random.next();
    m_centres.emplace_back(x, y);
    m_clumps.push_back({size[i], dry[i], bright[i], hue[i], random.next()});
  }
}

const ShellClump& ShellClumps::at(glm::vec2 place) const {
  const glm::vec2 at = (place - glm::floor(place)) * static_cast<float>(m_cells);
  const glm::ivec2 cell(at);
  float nearest = 1e9f;
  std::size_t found = 0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      const glm::ivec2 beside = cell + glm::ivec2(x, y), inside = (beside + m_cells) % m_cells;
      const auto i = static_cast<std::size_t>(inside.y * m_cells + inside.x);
      const glm::vec2 away = glm::vec2(beside) + m_centres[i] - at;
      if (glm::dot(away, away) >= nearest) continue;
      nearest = glm::dot(away, away);
      found = i;
    }
  }
  return m_clumps[found];
}

}  // namespace windloom
