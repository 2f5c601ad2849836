#include "editor/core/speed_histogram.hpp"

#include <algorithm>
#include <cmath>

namespace windloom::editor {
namespace {

// So many cells tell a part to a tenth of a percent, and take less than a millisecond.
constexpr std::size_t kMostCells = 250'000;

}  // namespace

SpeedHistogram speedHistogram(std::span<const glm::vec2> cells, float fullScale) {
  SpeedHistogram histogram;
  const std::size_t stride = 1 + cells.size() / (kMostCells + 1);
  float squared = 0;
  for (std::size_t i = 0; i < cells.size(); i += stride) squared = std::max(squared, glm::dot(cells[i], cells[i]));
  histogram.fastest = std::sqrt(squared);
  histogram.top = std::max(fullScale, histogram.fastest);
  std::array<long, SpeedHistogram::kBins> counts{};
  long clipped = 0, all = 0;
  const float scale = static_cast<float>(SpeedHistogram::kBins) / histogram.top;
  for (std::size_t i = 0; i < cells.size(); i += stride) {
    const float speed = glm::length(cells[i]);
    ++counts[static_cast<std::size_t>(std::min(static_cast<int>(speed * scale), SpeedHistogram::kBins - 1))];
    clipped += speed > fullScale ? 1 : 0;
    ++all;
  }
  if (all == 0) return histogram;
  const auto partOf = [&](long count) {
    return static_cast<float>(static_cast<double>(count) / static_cast<double>(all));
  };
  std::transform(counts.begin(), counts.end(), histogram.parts.begin(), partOf);
  histogram.clipped = partOf(clipped);
  return histogram;
}

}  // namespace windloom::editor
