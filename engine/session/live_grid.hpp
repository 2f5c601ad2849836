#pragma once
// Which resolution the live wind runs on where the CPU computes it. Pure.

#include <glm/glm.hpp>
#include <vector>

#include "engine/model/project.hpp"

namespace windloom {

/// Picks a grid that holds real time from measured step times. Starts at kFirstSide cells on the longer
/// side (or the project's grid where that is smaller) and moves in steps of the ladder.
class LiveGridControl {
 public:
  static constexpr int kFirstSide = 256;

  explicit LiveGridControl(const FieldSettings& field);

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
