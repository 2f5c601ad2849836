#include "engine/session/resample.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/contract.hpp"

namespace windloom {

Resampler::Resampler(glm::ivec2 from, glm::ivec2 to, glm::bvec2 wraps)
    : m_from(from), m_to(to), m_columns(tapsFor(from.x, to.x, wraps.x)), m_rows(tapsFor(from.y, to.y, wraps.y)) {}

std::vector<Resampler::Tap> Resampler::tapsFor(int from, int to, bool wraps) {
  WL_REQUIRE(from > 0 && to > 0, "a field has cells");
  std::vector<Tap> taps(static_cast<std::size_t>(to));
  const double ratio = static_cast<double>(from) / to;  // old cells under a new one
  for (int n = 0; n < to; ++n) {
    Tap& tap = taps[static_cast<std::size_t>(n)];
    if (ratio >= 1.0) {
      const double low = n * ratio, high = (n + 1) * ratio;
      tap.first = static_cast<int>(low);
      const int last = std::min(static_cast<int>(std::ceil(high)), from) - 1;
      for (int i = tap.first; i <= last; ++i) {
        const double covered = std::min(high, i + 1.0) - std::max(low, static_cast<double>(i));
        tap.weights.push_back(static_cast<float>(std::max(0.0, covered) / ratio));
      }
    } else if (wraps) {
      const double at = (n + 0.5) * ratio - 0.5, below = std::floor(at);
      tap.first = (static_cast<int>(below) + from) % from;
      const auto weight = static_cast<float>(at - below);
      tap.weights = {1.0f - weight, weight};
    } else {
      const double at = std::clamp((n + 0.5) * ratio - 0.5, 0.0, from - 1.0);
      tap.first = std::min(static_cast<int>(at), std::max(0, from - 2));
      const auto weight = static_cast<float>(at - tap.first);
      tap.weights = {1.0f - weight, weight};
      if (from == 1) tap.weights = {1.0f};
    }
  }
  return taps;
}

void Resampler::apply(std::span<const glm::vec2> in, std::vector<glm::vec2>& out) {
  const auto width = static_cast<std::size_t>(m_from.x), height = static_cast<std::size_t>(m_from.y);
  const auto newWidth = static_cast<std::size_t>(m_to.x);
  WL_REQUIRE(in.size() == width * height, "a field has one value for each cell");
  m_narrowed.resize(newWidth * height);
  for (std::size_t k = 0; k < height; ++k) {
    for (std::size_t n = 0; n < newWidth; ++n) {
      const Tap& tap = m_columns[n];
      const glm::vec2* row = in.data() + k * width;
      glm::vec2 sum(0);
      auto at = static_cast<std::size_t>(tap.first);
      for (const float weight : tap.weights) {
        sum += row[at] * weight;
        if (++at == width) at = 0;
      }
      m_narrowed[k * newWidth + n] = sum;
    }
  }
  out.assign(newWidth * static_cast<std::size_t>(m_to.y), glm::vec2(0));
  for (std::size_t m = 0; m < m_rows.size(); ++m) {
    const Tap& tap = m_rows[m];
    glm::vec2* row = out.data() + m * newWidth;
    auto at = static_cast<std::size_t>(tap.first);
    for (const float weight : tap.weights) {
      const glm::vec2* from = m_narrowed.data() + at * newWidth;
      for (std::size_t n = 0; n < newWidth; ++n) row[n] += from[n] * weight;
      if (++at == height) at = 0;
    }
  }
}

glm::bvec2 wrapsOf(const FieldSettings& field) {
  return {field.xMin == Border::Periodic && field.xMax == Border::Periodic,
          field.zMin == Border::Periodic && field.zMax == Border::Periodic};
}

}  // namespace windloom
