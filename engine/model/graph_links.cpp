#include "engine/model/graph_links.hpp"

#include <unordered_map>

namespace windloom {

GraphLinks::GraphLinks(const WindGraph& graph)
    : from(graph.arrows.size(), kNone),
      to(graph.arrows.size(), kNone),
      incoming(graph.points.size(), 0),
      m_first(graph.points.size() + 1, 0) {
  std::unordered_map<Id, std::uint32_t> index;
  index.reserve(graph.points.size());
  for (std::uint32_t i = 0; i < graph.points.size(); ++i) index.emplace(graph.points[i].id, i);
  for (std::uint32_t a = 0; a < graph.arrows.size(); ++a) {
    const auto begin = index.find(graph.arrows[a].from);
    const auto end = index.find(graph.arrows[a].to);
    if (begin == index.end() || end == index.end()) continue;
    from[a] = begin->second;
    to[a] = end->second;
    ++incoming[to[a]];
    ++m_first[from[a] + 1];
  }
  for (std::size_t i = 1; i < m_first.size(); ++i) m_first[i] += m_first[i - 1];
  m_outgoing.resize(m_first.back());
  std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
  for (std::uint32_t a = 0; a < graph.arrows.size(); ++a) {
    if (from[a] != kNone) m_outgoing[next[from[a]]++] = a;
  }
}

}  // namespace windloom
