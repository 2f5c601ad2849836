#include "engine/model/wind_graph.hpp"

#include <algorithm>

#include "engine/model/graph_links.hpp"

namespace windloom {
namespace {

/// Marks everything that arrows lead to from `start`.
void markReached(const GraphLinks& links, std::uint32_t start, std::vector<char>& reached) {
  std::vector<std::uint32_t> open{start};
  reached[start] = 1;
  while (!open.empty()) {
    const std::uint32_t point = open.back();
    open.pop_back();
    for (const std::uint32_t arrow : links.outgoing(point)) {
      const std::uint32_t next = links.to[arrow];
      if (!reached[next]) open.push_back(next);
      reached[next] = 1;
    }
  }
}

/// Roots of the rings that nothing in `reached` leads to. Starts are taken in ascending id, so the
/// first in a ring has its lowest id; of those, the ones that a later start leads to are no roots.
std::vector<std::uint32_t> ringRoots(const WindGraph& graph, const GraphLinks& links, std::vector<char> reached) {
  std::vector<std::uint32_t> byId;
  for (std::uint32_t i = 0; i < graph.points.size(); ++i) {
    if (!reached[i] && links.incoming[i] > 0) byId.push_back(i);
  }
  std::ranges::sort(byId, {}, [&](std::uint32_t i) { return graph.points[i].id; });
  std::vector<std::uint32_t> starts;
  std::vector<char> forward = reached;
  for (const std::uint32_t i : byId) {
    if (forward[i]) continue;
    starts.push_back(i);
    markReached(links, i, forward);
  }
  std::vector<std::uint32_t> roots;
  for (auto start = starts.rbegin(); start != starts.rend(); ++start) {
    if (reached[*start]) continue;
    roots.push_back(*start);
    markReached(links, *start, reached);
  }
  return roots;
}

}  // namespace

const Point* findPoint(const WindGraph& graph, Id id) {
  const auto it = std::ranges::find(graph.points, id, &Point::id);
  return it == graph.points.end() ? nullptr : &*it;
}

const Arrow* findArrow(const WindGraph& graph, Id id) {
  const auto it = std::ranges::find(graph.arrows, id, &Arrow::id);
  return it == graph.arrows.end() ? nullptr : &*it;
}

const Signal* findSignal(const WindGraph& graph, Id root) {
  const auto it = std::ranges::find(graph.signals, root, &Signal::root);
  return it == graph.signals.end() ? nullptr : &*it;
}

std::vector<std::uint32_t> rootIndices(const WindGraph& graph, const GraphLinks& links) {
  std::vector<std::uint32_t> roots;
  std::vector<char> reached(graph.points.size(), 0);
  for (std::uint32_t i = 0; i < graph.points.size(); ++i) {
    const bool source = links.incoming[i] == 0 && !links.outgoing(i).empty();
    if (!source && !graph.points[i].root) continue;
    roots.push_back(i);
    if (!reached[i]) markReached(links, i, reached);
  }
  for (const std::uint32_t i : ringRoots(graph, links, std::move(reached))) roots.push_back(i);
  std::ranges::sort(roots, {}, [&](std::uint32_t i) { return graph.points[i].id; });
  return roots;
}

std::vector<Id> findRoots(const WindGraph& graph) {
  std::vector<Id> ids;
  for (const std::uint32_t i : rootIndices(graph, GraphLinks(graph))) ids.push_back(graph.points[i].id);
  return ids;
}

}  // namespace windloom
