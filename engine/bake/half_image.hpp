#pragma once
// A frame as half floats in the target's image: what the floating-point image and texture formats hold.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/bake/target_frame.hpp"

namespace windloom {

/// How a pixel's components lie. R and G are the vector along the target's two axes, B its length, A is 1.
enum class HalfLayout {
  Rg,       ///< R G of a pixel, then those of the next
  Rgba,     ///< R G B A of a pixel, then those of the next
  RowsBgr,  ///< of each row all B, then all G, then all R: the lines of an EXR file
};

int halvesPerPixel(HalfLayout layout);

class HalfImage {
 public:
  HalfImage(const BakeHeader& header, HalfLayout layout);

  /// The frame's pixels, row 0 (the top of an image file) first, in target().unit(), rounded as half.hpp says; they
  /// stay until the next call.
  std::span<const std::uint16_t> of(std::span<const glm::vec2> cells);

  [[nodiscard]] const TargetFrame& target() const { return m_target; }
  /// target().unit(): no vector of the last frame is longer; 0 for HalfLayout::Rg, which needs no lengths.
  [[nodiscard]] float longest() const { return m_longest; }

 private:
  void measureLengths();

  TargetFrame m_target;
  HalfLayout m_layout;
  std::size_t m_width;
  std::vector<glm::vec2> m_vectors;
  std::vector<float> m_lengths;
  std::vector<std::uint16_t> m_halves;
  float m_longest = 0;
};

}  // namespace windloom
