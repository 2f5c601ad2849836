#pragma once
// Which resolution the live wind runs on, by how long its steps take. Pure.

#include <glm/glm.hpp>
#include <vector>

#include "engine/model/project.hpp"

namespace windloom {

enum class LiveGridStart {
  Coarse,   ///< kFirstSide cells on the longer side, or the project's grid where that is smaller
  Project,  ///< the project's grid, left only once it has been measured as too slow
};

/// Picks a grid that holds real time from measured step times; moves in steps of the ladder.
class LiveGridControl {
 public:
  static constexpr int kFirstSide = 256;

  explicit LiveGridControl(const FieldSettings& field, LiveGridStart start = LiveGridStart::Coarse);

  [[nodiscard]] glm::ivec2 resolution() const { return m_resolution; }

  /// A step took so long. True: resolution() has changed.
  bool stepDone(double milliseconds);

 private:
  bool moveTo(int side);

  FieldSettings m_field;
  glm::ivec2 m_resolution{0};
  std::vector<double> m_times;
  int m_ceiling = 0;  // longer side that was too slow once
};

/// The project's resolution shrunk so that its longer side has at most `side` cells; at least 8 on each.
glm::ivec2 shrinkResolution(glm::ivec2 resolution, int side);

}  // namespace windloom
