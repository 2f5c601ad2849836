// How shells bend: Bakay, Lalonde & Heidrich, "Real-time animated grass", 2002. Where they stand is ours: the paper
// spaces them evenly and names the better choice as future work.
#include "engine/grass/shell_placing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace windloom {
namespace {

constexpr int kIntensities = 16;  // winds that the error is looked at for

/// How far each pair of ends is off, by (lower, upper).
class StraightErrors {
 public:
  StraightErrors(int segments, float limit, float stiffness)
      : m_side(static_cast<std::size_t>(segments) + 1), m_error(m_side * m_side, 0.0f) {
    // The first row is still air, in which nothing bends.
    const std::vector<glm::vec2> table = shellOffsetTable(segments, kIntensities + 1, limit, stiffness);
    for (int lower = 0; lower < segments; ++lower) {
      for (int upper = lower + 2; upper <= segments; ++upper) {
        float& most = m_error[index(lower, upper)];
        for (std::size_t row = 1; row <= kIntensities; ++row) {
          most = std::max(most, offStraight(&table[row * m_side], lower, upper));
        }
      }
    }
  }

  [[nodiscard]] float operator()(int lower, int upper) const { return m_error[index(lower, upper)]; }

 private:
  std::size_t m_side;
  std::vector<float> m_error;

  [[nodiscard]] std::size_t index(int lower, int upper) const {
    return static_cast<std::size_t>(lower) * m_side + static_cast<std::size_t>(upper);
  }

  static float offStraight(const glm::vec2* bent, int lower, int upper) {
    float most = 0.0f;
    for (int i = lower + 1; i < upper; ++i) {
      const float part = static_cast<float>(i - lower) / static_cast<float>(upper - lower);
      const glm::vec2 off = bent[i] - glm::mix(bent[lower], bent[upper], part);
      most = std::max(most, glm::dot(off, off));
    }
    return std::sqrt(most);
  }
};

float largestError(const std::vector<int>& ends, const StraightErrors& errors) {
  float most = 0.0f;
  int lower = 0;
  for (const int end : ends) {
    most = std::max(most, errors(lower, end));
    lower = end;
  }
  return most;
}

/// `reaching` at a height of 0..1.
float reachingAt(std::span<const float> reaching, float height) {
  if (reaching.empty()) return 1.0f;
  const float at = height * static_cast<float>(reaching.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), reaching.size() - 1);
  return std::lerp(reaching[low], reaching[std::min(low + 1, reaching.size() - 1)], at - static_cast<float>(low));
}

/// Ends that may be chosen, ascending, `segments` always among them.
std::vector<int> choices(int segments, std::span<const int> among) {
  std::vector<int> ends;
  for (int end = 1; end <= segments; ++end) {
    if (among.empty() || end == segments || std::ranges::find(among, end) != among.end()) ends.push_back(end);
  }
  return ends;
}

/// Of a placing up to some end: its largest weighted error, then the sum of their squares, which tells placings apart
/// that have the largest in common.
struct Cost {
  float most = std::numeric_limits<float>::max(), sum = 0;
  [[nodiscard]] Cost with(float error) const { return {std::max(most, error), sum + error * error}; }
  [[nodiscard]] bool operator<(const Cost& other) const {
    return std::pair(most, sum) < std::pair(other.most, other.sum);
  }
};

/// The best `shells` of `ends` with the last of them: best up to each end with one shell, two and so on.
std::vector<int> leastOf(const std::vector<int>& ends, int shells, const StraightErrors& errors,
                         const std::vector<float>& weights) {
  const std::size_t count = ends.size(), rounds = static_cast<std::size_t>(shells);
  std::vector<Cost> costs(rounds * count);
  std::vector<std::size_t> before(rounds * count, 0);
  for (std::size_t e = 0; e < count; ++e) costs[e] = Cost{0.0f, 0.0f}.with(weights[0] * errors(0, ends[e]));
  for (std::size_t round = 1; round < rounds; ++round) {
    for (std::size_t e = round; e < count; ++e) {
      Cost& best = costs[round * count + e];
      for (std::size_t p = round - 1; p < e; ++p) {
        const float error = weights[static_cast<std::size_t>(ends[p])] * errors(ends[p], ends[e]);
        const Cost cost = costs[(round - 1) * count + p].with(error);
        if (!(cost < best)) continue;
        best = cost;
        before[round * count + e] = p;
      }
    }
  }
  std::vector<int> chosen(rounds);
  std::size_t at = count - 1;
  for (std::size_t round = rounds; round-- > 0;) {
    chosen[round] = ends[at];
    at = before[round * count + at];
  }
  return chosen;
}

}  // namespace

std::vector<glm::vec2> shellOffsetTable(int segments, int intensities, float limit, float stiffness) {
  std::vector<glm::vec2> table;
  table.reserve(static_cast<std::size_t>(intensities) * (static_cast<std::size_t>(segments) + 1));
  const float step = 1.0f / static_cast<float>(segments);
  for (int k = 0; k < intensities; ++k) {
    const float part = intensities > 1 ? static_cast<float>(k) / static_cast<float>(intensities - 1) : 0.0f;
    shared::ShellOffset offset{0.0f, 0.0f};
    table.emplace_back(0.0f);
    for (int i = 1; i <= segments; ++i) {
      offset = shared::shellNext(offset, i, segments, step, part * limit, stiffness);
      table.emplace_back(offset.along, offset.aside);
    }
  }
  return table;
}

ShellPlacing evenShells(int segments, int shells, float limit, float stiffness) {
  const int count = std::clamp(shells, 1, segments);
  ShellPlacing placing;
  for (int k = 1; k <= count; ++k) placing.ends.push_back((2 * k * segments + count) / (2 * count));
  placing.error = largestError(placing.ends, StraightErrors(segments, limit, stiffness));
  return placing;
}

ShellPlacing placeShells(int segments, int shells, float limit, float stiffness, std::span<const float> reaching,
                         std::span<const int> among) {
  const StraightErrors errors(segments, limit, stiffness);
  const std::vector<int> ends = choices(segments, among);
  std::vector<float> weights;
  for (int end = 0; end <= segments; ++end) {
    weights.push_back(reachingAt(reaching, static_cast<float>(end) / static_cast<float>(segments)));
  }
  ShellPlacing placing;
  placing.ends = leastOf(ends, std::clamp(shells, 1, static_cast<int>(ends.size())), errors, weights);
  placing.error = largestError(placing.ends, errors);
  return placing;
}

}  // namespace windloom
