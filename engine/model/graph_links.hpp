#pragma once
// A wind graph by index instead of by id, for passes over all of it. Arrows with a missing end are
// left out, so that a graph that isn't valid yet can still be drawn.

#include <span>
#include <vector>

#include "engine/model/wind_graph.hpp"

namespace windloom {

struct GraphLinks {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  explicit GraphLinks(const WindGraph& graph);

  /// Indices of the arrows that leave a point.
  [[nodiscard]] std::span<const std::uint32_t> outgoing(std::uint32_t point) const {
    return std::span(m_outgoing).subspan(m_first[point], m_first[point + 1] - m_first[point]);
  }

  std::vector<std::uint32_t> from, to;   ///< by arrow index: point indices, or kNone for both
  std::vector<std::uint32_t> incoming;   ///< by point index: how many arrows lead to it

 private:
  std::vector<std::uint32_t> m_first, m_outgoing;
};

/// findRoots by index, in ascending order of ids.
std::vector<std::uint32_t> rootIndices(const WindGraph& graph, const GraphLinks& links);

}  // namespace windloom
