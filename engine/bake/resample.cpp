#include "engine/bake/resample.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/contract.hpp"

namespace windloom {

Resampler::Resampler(glm::ivec2 from, glm::ivec2 to)
    : m_from(from), m_to(to), m_columns(tapsFor(from.x, to.x)), m_rows(tapsFor(from.y, to.y)) {}

std::vector<Resampler::Tap> Resampler::tapsFor(int from, int to) {
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
      const glm::vec2* from = in.data() + k * width + static_cast<std::size_t>(tap.first);
      glm::vec2 sum(0);
      for (std::size_t i = 0; i < tap.weights.size(); ++i) sum += from[i] * tap.weights[i];
      m_narrowed[k * newWidth + n] = sum;
    }
  }
  out.assign(newWidth * static_cast<std::size_t>(m_to.y), glm::vec2(0));
  for (std::size_t m = 0; m < m_rows.size(); ++m) {
    const Tap& tap = m_rows[m];
    glm::vec2* row = out.data() + m * newWidth;
    for (std::size_t k = 0; k < tap.weights.size(); ++k) {
      const glm::vec2* from = m_narrowed.data() + (static_cast<std::size_t>(tap.first) + k) * newWidth;
      for (std::size_t n = 0; n < newWidth; ++n) row[n] += from[n] * tap.weights[k];
    }
  }
}

}  // namespace windloom
