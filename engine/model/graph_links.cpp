#include "engine/model/graph_links.hpp"

#include "engine/model/id_index.hpp"

namespace windloom {

GraphLinks::GraphLinks(const WindGraph& graph)
    : from(graph.arrows.size(), kNone),
      to(graph.arrows.size(), kNone),
      incoming(graph.points.size(), 0),
      m_first(graph.points.size() + 1, 0) {
  const IdIndex index(graph.points);
  for (std::uint32_t a = 0; a < graph.arrows.size(); ++a) {
    const auto begin = index.find(graph.arrows[a].from);
    const auto end = index.find(graph.arrows[a].to);
    if (!begin || !end) continue;
    from[a] = *begin;
    to[a] = *end;
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
