#pragma once
// Clumps of blades in a square of ground that wraps around. Pure.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace windloom {

/// What blades of a clump have in common, each 0..1 and even over the clumps.
struct ShellClump {
  float size = 0, dry = 0, bright = 0, hue = 0;
  float lean = 0;  ///< turns
};

/// About `sideM` / 0.75 by as many of them, one at least. Neighbours differ more than by chance: a meadow shows the
/// same square again and again, and what is alike over a large part of it would be seen as a pattern.
class ShellClumps {
 public:
  ShellClumps(float sideM, std::uint32_t seed);

  /// The one whose centre is nearest; `place` in squares, any.
  [[nodiscard]] const ShellClump& at(glm::vec2 place) const;
  [[nodiscard]] const std::vector<ShellClump>& all() const { return m_clumps; }
  /// Clumps along a side.
  [[nodiscard]] int cells() const { return m_cells; }

 private:
  int m_cells;
  std::vector<ShellClump> m_clumps;
  std::vector<glm::vec2> m_centres;  ///< in their cells, 0..1
};

}  // namespace windloom
