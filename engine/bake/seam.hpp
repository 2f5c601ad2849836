#pragma once
// How smoothly a recording repeats.

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace windloom {

/// Largest changes of any cell, m/s.
struct SeamReport {
  float seam = 0;  ///< from the last frame to the first
  float step = 0;  ///< from any other frame to the next; a seam below this isn't seen
};

/// Largest length of a cell's difference.
float largestChange(std::span<const glm::vec2> a, std::span<const glm::vec2> b);

/// Watches frames go by.
class SeamMeter {
 public:
  /// Frame `n` of the recording; `before` is the frame that plays before it (for frame 0 the last one).
  void compare(int n, std::span<const glm::vec2> before, std::span<const glm::vec2> frame);
  [[nodiscard]] SeamReport report() const { return m_report; }

 private:
  SeamReport m_report;
};

}  // namespace windloom
