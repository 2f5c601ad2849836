#pragma once
// How the speeds of a field lie within the full scale of an 8-bit format.

#include <array>
#include <glm/glm.hpp>
#include <span>

namespace windloom::editor {

struct SpeedHistogram {
  static constexpr int kBins = 24;  ///< equal parts of 0 to `top`

  std::array<float, kBins> parts{};  ///< of all cells, each 0..1; speeds of `top` and over are in the last
  float top = 1;                     ///< m/s: end of the last bin; > 0
  float fastest = 0;                 ///< m/s
  float clipped = 0;                 ///< part of the cells that are faster than the full scale, 0..1
};

/// `fullScale` in m/s, > 0; the bins reach to it or to the fastest cell, whichever is more. Large fields are
/// sampled evenly.
SpeedHistogram speedHistogram(std::span<const glm::vec2> cells, float fullScale);

}  // namespace windloom::editor
