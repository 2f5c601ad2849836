#include "engine/bake/seam.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/contract.hpp"

namespace windloom {

float largestChange(std::span<const glm::vec2> a, std::span<const glm::vec2> b) {
  WL_REQUIRE(a.size() == b.size(), "frames of one recording have one size");
  float square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const glm::vec2 change = a[i] - b[i];
    square = std::max(square, glm::dot(change, change));
  }
  return std::sqrt(square);
}

void SeamMeter::compare(int n, std::span<const glm::vec2> before, std::span<const glm::vec2> frame) {
  float& largest = n == 0 ? m_report.seam : m_report.step;
  largest = std::max(largest, largestChange(before, frame));
}

}  // namespace windloom
