#include "editor/core/graph_edits.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "editor/core/id_index.hpp"

namespace windloom::editor {
namespace {

Arrow arrowLike(const Arrow& model, Id id, Id from, Id to) {
  Arrow arrow = model;
  arrow.id = id;
  arrow.from = from;
  arrow.to = to;
  arrow.name.clear();
  arrow.extra.clear();
  arrow.hidden = arrow.muted = arrow.locked = false;
  return arrow;
}

Edit named(std::string label) {
  Edit edit;
  edit.label = std::move(label);
  return edit;
}

std::vector<Id> pointsOf(const IdIndex& index, std::span<const Id> ids) {
  std::vector<Id> points;
  for (const Id id : ids) {
    if (index.point(id)) points.push_back(id);
  }
  return points;
}

std::uint64_t endsKey(Id from, Id to) {
  return std::uint64_t{from} << 32 | to;
}

/// Replaces every point of `gone` by `kept`, which is then at `position`.
Edit mergeInto(const Project& project, const std::unordered_set<Id>& gone, const Point& kept, glm::vec2 position) {
  const WindGraph& graph = *project.graph;
  Edit edit = named("Merge points");
  Erase erase{{gone.begin(), gone.end()}};
  Point merged = kept;
  merged.position = position;
  std::unordered_set<std::uint64_t> ends;
  for (const Arrow& arrow : graph.arrows) {
    if (!gone.contains(arrow.from) && !gone.contains(arrow.to)) ends.insert(endsKey(arrow.from, arrow.to));
  }
  for (const Arrow& arrow : graph.arrows) {
    if (!gone.contains(arrow.from) && !gone.contains(arrow.to)) continue;
    Arrow moved = arrow;
    if (gone.contains(arrow.from)) moved.from = kept.id;
    if (gone.contains(arrow.to)) moved.to = kept.id;
    if (moved.from == moved.to || !ends.insert(endsKey(moved.from, moved.to)).second) {
      erase.ids.push_back(arrow.id);
    } else {
      edit.steps.emplace_back(Put<Arrow>{std::move(moved)});
    }
  }
  for (const Point& point : graph.points) {
    if (gone.contains(point.id)) merged.root = merged.root || point.root;
  }
  edit.steps.emplace_back(Put<Point>{std::move(merged)});
  if (!findSignal(graph, kept.id)) {
    for (const Signal& signal : graph.signals) {
      if (!gone.contains(signal.root)) continue;
      Signal taken = signal;
      taken.root = kept.id;
      edit.steps.emplace_back(Put<Signal>{std::move(taken)});
      break;
    }
  }
  edit.steps.emplace_back(std::move(erase));
  return edit;
}

/// How many arrows lead to and from each point.
struct Degrees {
  std::unordered_map<Id, int> in, out;
  explicit Degrees(std::span<const Arrow> arrows) {
    for (const Arrow& arrow : arrows) {
      ++out[arrow.from];
      ++in[arrow.to];
    }
  }
  [[nodiscard]] bool startsFlow(Id id) const { return !in.contains(id) && out.contains(id); }
};

/// Sends the signals of points that no longer start a flow to the roots upstream of them.
void moveSignals(const WindGraph& graph, const std::vector<Arrow>& arrows, Edit& edit) {
  const Degrees before(graph.arrows), after(arrows);
  std::unordered_map<Id, std::vector<Id>> comesFrom;
  for (const Arrow& arrow : arrows) comesFrom[arrow.to].push_back(arrow.from);
  std::unordered_set<Id> taken;
  for (const Signal& signal : graph.signals) taken.insert(signal.root);
  for (const Signal& signal : graph.signals) {
    if (!before.startsFlow(signal.root) || after.startsFlow(signal.root)) continue;
    std::vector<Id> open{signal.root};
    std::unordered_set<Id> seen{signal.root};
    bool moved = false;
    while (!open.empty()) {
      const Id point = open.back();
      open.pop_back();
      if (after.startsFlow(point) && taken.insert(point).second) {
        Signal copy = signal;
        copy.root = point;
        edit.steps.emplace_back(Put<Signal>{std::move(copy)});
        moved = true;
      }
      for (const Id next : comesFrom[point]) {
        if (seen.insert(next).second) open.push_back(next);
      }
    }
    if (moved) edit.steps.emplace_back(EraseSignal{signal.root});
  }
}

}  // namespace

ConnectResult connectEdit(const Project& project, Id from, Id to, const Arrow& model) {
  ConnectResult result{named("Connect points"), 0};
  if (from == to || !findPoint(*project.graph, from) || !findPoint(*project.graph, to)) return result;
  result.arrow = nextFreeId(project);
  result.edit.steps.emplace_back(Put<Arrow>{arrowLike(model, result.arrow, from, to)});
  return result;
}

FeedResult feedEdit(const Project& project, glm::vec2 position, Id to, const Arrow& model) {
  FeedResult result{named("Draw tree"), 0, 0};
  if (!findPoint(*project.graph, to)) return result;
  FreeIds fresh(project);
  result.root = fresh.take();
  result.arrow = fresh.take();
  Point root;
  root.id = result.root;
  root.position = position;
  result.edit.steps.emplace_back(Put<Point>{std::move(root)});
  result.edit.steps.emplace_back(Put<Arrow>{arrowLike(model, result.arrow, result.root, to)});
  return result;
}

InsertResult insertPointEdit(const Project& project, Id arrow, float along) {
  InsertResult result{named("Insert point"), 0, 0};
  const Arrow* old = findArrow(*project.graph, arrow);
  if (!old) return result;
  const Point* from = findPoint(*project.graph, old->from);
  const Point* to = findPoint(*project.graph, old->to);
  if (!from || !to) return result;
  FreeIds fresh(project);
  result.point = fresh.take();
  result.arrow = fresh.take();
  Point point;
  point.id = result.point;
  point.position = glm::mix(from->position, to->position, std::clamp(along, 0.05f, 0.95f));
  Arrow first = *old, second = *old;
  first.to = result.point;
  first.swirl = 0.0f;
  second.id = result.arrow;
  second.from = result.point;
  second.name.clear();
  result.edit.steps.emplace_back(Put<Point>{std::move(point)});
  result.edit.steps.emplace_back(Put<Arrow>{std::move(first)});
  result.edit.steps.emplace_back(Put<Arrow>{std::move(second)});
  return result;
}

Edit mergePointsEdit(const Project& project, std::span<const Id> ids) {
  const IdIndex index(project);
  const std::vector<Id> points = pointsOf(index, ids);
  const std::unordered_set<Id> different(points.begin(), points.end());
  if (different.size() < 2) return named("Merge points");
  glm::vec2 mean(0.0f);
  for (const Id id : different) mean += index.point(id)->position;
  mean /= static_cast<float>(different.size());
  std::unordered_set<Id> gone = different;
  gone.erase(points.back());
  return mergeInto(project, gone, *index.point(points.back()), mean);
}

Edit mergeIntoEdit(const Project& project, Id gone, Id kept) {
  const Point* point = findPoint(*project.graph, kept);
  if (gone == kept || !point || !findPoint(*project.graph, gone)) return named("Merge points");
  return mergeInto(project, {gone}, *point, point->position);
}

SplitResult splitEdit(const Project& project, std::span<const Id> ids) {
  const WindGraph& graph = *project.graph;
  const IdIndex index(project);
  SplitResult result{named("Split"), {}};
  std::vector<Arrow> arrows = graph.arrows;
  std::unordered_map<Id, std::size_t> placeOf;
  std::unordered_map<Id, std::vector<std::pair<std::size_t, bool>>> touching;  // incoming first; true: at its end
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    placeOf[arrows[i].id] = i;
    touching[arrows[i].to].emplace_back(i, true);
  }
  for (std::size_t i = 0; i < arrows.size(); ++i) touching[arrows[i].from].emplace_back(i, false);

  std::unordered_set<std::size_t> changed;
  FreeIds fresh(project);
  const auto cut = [&](std::size_t arrow, bool atEnd) {
    Id& end = atEnd ? arrows[arrow].to : arrows[arrow].from;
    Point copy = *index.point(end);
    copy.id = fresh.take();
    copy.name.clear();
    copy.root = false;
    end = copy.id;
    changed.insert(arrow);
    result.points.push_back(copy.id);
    result.edit.steps.emplace_back(Put<Point>{std::move(copy)});
  };
  std::unordered_set<Id> done;
  for (const Id id : ids) {
    if (!index.point(id) || !done.insert(id).second) continue;
    const auto& ends = touching[id];
    for (std::size_t i = 1; i < ends.size(); ++i) cut(ends[i].first, ends[i].second);
  }
  for (const Id id : ids) {
    if (!index.arrow(id) || !done.insert(id).second) continue;
    const std::size_t arrow = placeOf[id];
    const Id from = arrows[arrow].from;
    if (index.point(from) && !done.contains(from) && touching[from].size() > 1) cut(arrow, false);
  }
  for (std::size_t i = 0; i < arrows.size(); ++i) {
    if (changed.contains(i)) result.edit.steps.emplace_back(Put<Arrow>{arrows[i]});
  }
  return result;
}

Edit dissolveEdit(const Project& project, std::span<const Id> ids) {
  const IdIndex index(project);
  std::vector<Arrow> arrows = project.graph->arrows;
  std::unordered_set<Id> changed;
  Edit edit = named("Dissolve points");
  Erase erase;
  for (const Id id : ids) {
    if (!index.point(id)) continue;
    const auto into = std::find_if(arrows.begin(), arrows.end(), [&](const Arrow& a) { return a.to == id; });
    const auto out = std::find_if(arrows.begin(), arrows.end(), [&](const Arrow& a) { return a.from == id; });
    const auto touching =
        std::count_if(arrows.begin(), arrows.end(), [&](const Arrow& a) { return a.from == id || a.to == id; });
    erase.ids.push_back(id);
    const bool passes = touching == 2 && into != arrows.end() && out != arrows.end() && into->from != out->to;
    const bool doubled = passes && std::any_of(arrows.begin(), arrows.end(),
                                               [&](const Arrow& a) { return a.from == into->from && a.to == out->to; });
    if (passes && !doubled) {
      into->to = out->to;
      into->swirl = out->swirl;
      changed.insert(into->id);
      erase.ids.push_back(out->id);
      arrows.erase(out);
    } else {
      std::erase_if(arrows, [&](const Arrow& a) { return a.from == id || a.to == id; });
    }
  }
  if (erase.ids.empty()) return edit;
  // The arrows first: those that now pass by an erased point would go with it.
  for (const Arrow& arrow : arrows) {
    if (changed.contains(arrow.id)) edit.steps.emplace_back(Put<Arrow>{arrow});
  }
  edit.steps.emplace_back(std::move(erase));
  return edit;
}

Edit reverseEdit(const Project& project, std::span<const Id> ids) {
  const std::vector<Id> turned = arrowsOf(project, ids);
  const std::unordered_set<Id> turnedSet(turned.begin(), turned.end());
  Edit edit = named(turned.size() == 1 ? "Reverse arrow" : "Reverse arrows");
  std::vector<Arrow> arrows = project.graph->arrows;
  for (Arrow& arrow : arrows) {
    if (!turnedSet.contains(arrow.id)) continue;
    std::swap(arrow.from, arrow.to);
    edit.steps.emplace_back(Put<Arrow>{arrow});
  }
  moveSignals(*project.graph, arrows, edit);
  return edit;
}

Edit reparentEdit(const Project& project, std::span<const Id> ids) {
  const IdIndex index(project);
  const std::vector<Id> points = pointsOf(index, ids);
  Edit edit = named("Reparent");
  if (points.size() < 2) return edit;
  const Id parent = points.back();
  std::unordered_set<Id> open(points.begin(), points.end());
  open.erase(parent);
  for (const Arrow& arrow : project.graph->arrows) {
    if (open.erase(arrow.to) == 0 || arrow.from == parent) continue;
    Arrow moved = arrow;
    moved.from = parent;
    edit.steps.emplace_back(Put<Arrow>{std::move(moved)});
  }
  return edit;
}

}  // namespace windloom::editor
