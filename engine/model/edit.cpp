#include "engine/model/edit.hpp"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>

#include "engine/model/id_index.hpp"
#include "engine/model/sphere_packing.hpp"
#include "engine/model/validate.hpp"

namespace windloom {
namespace {

template <class Record>
Id keyOf(const Record& record) {
  return record.id;
}
Id keyOf(const Signal& signal) {
  return signal.root;
}

/// A list of records under edit; its ids are looked up once, when they are first needed.
template <class Record>
class Draft {
 public:
  explicit Draft(std::vector<Record> records) : m_records(std::move(records)) {}

  void put(const Record& record) {
    if (!m_index) m_index.emplace(m_records, [](const Record& r) { return keyOf(r); });
    if (const auto place = m_index->find(keyOf(record))) {
      m_records[*place] = record;
      return;
    }
    const auto [place, fresh] = m_added.emplace(keyOf(record), m_records.size());
    if (fresh) {
      m_records.push_back(record);
    } else {
      m_records[place->second] = record;
    }
  }

  template <class Predicate>
  void erase(Predicate&& goes) {
    if (std::erase_if(m_records, goes) == 0) return;
    m_index.reset();
    m_added.clear();
  }

  void reorder(const std::unordered_set<Id>& ids, Id before) {
    const auto moves = [&](const Record& record) { return ids.contains(record.id); };
    auto place = before == 0 ? m_records.end() : std::ranges::find(m_records, before, &Record::id);
    // Where the target moves, too, all stand before the first record after it that doesn't.
    while (place != m_records.end() && moves(*place)) ++place;
    std::stable_partition(m_records.begin(), place, [&](const Record& record) { return !moves(record); });
    std::stable_partition(place, m_records.end(), moves);
    m_index.reset();
    m_added.clear();
  }

  [[nodiscard]] const std::vector<Record>& records() const { return m_records; }
  [[nodiscard]] std::vector<Record> take() { return std::move(m_records); }

 private:
  std::vector<Record> m_records;
  std::optional<IdIndex> m_index;               // of the records that were there when it was made
  std::unordered_map<Id, std::size_t> m_added;  // of those put since
};

/// Null where it was read from another file than the one that is named now.
template <class Read>
void keepInStep(std::shared_ptr<const Read>& read, const std::string& file) {
  if (read && read->file != file) read.reset();
}

/// A project under edit. A part is copied when a step first touches it; the others stay shared.
class Editing {
 public:
  explicit Editing(const Project& project) : m_project(project) {}

  void operator()(const Put<Point>& step) { list(m_points, m_project.graph->points).put(step.record); }
  void operator()(const Put<Arrow>& step) { list(m_arrows, m_project.graph->arrows).put(step.record); }
  void operator()(const Put<Signal>& step) { list(m_signals, m_project.graph->signals).put(step.record); }
  void operator()(const Put<Obstacle>& step) { list(m_obstacles, *m_project.obstacles).put(step.record); }
  void operator()(const Put<Species>& step) { list(m_species, *m_project.species).put(inStep(step.record)); }
  void operator()(const Put<Collider>& step) { list(m_colliders, *m_project.colliders).put(inStep(step.record)); }
  void operator()(const Put<Surface>& step) { list(m_surfaces, *m_project.surfaces).put(inStep(step.record)); }
  void operator()(const Put<Rotor>& step) { list(m_rotors, *m_project.rotors).put(step.record); }
  void operator()(const Put<Probe>& step) { list(m_probes, *m_project.probes).put(step.record); }
  void operator()(const Put<Camera>& step) { list(m_cameras, *m_project.cameras).put(step.record); }
  void operator()(const SetName& step) { m_project.name = step.name; }
  void operator()(const Set<FieldSettings>& step) { set(m_project.field, step.part); }
  void operator()(const Set<SolverSettings>& step) { set(m_project.solver, step.part); }
  void operator()(const Set<AmbientWind>& step) { set(m_project.ambient, step.part); }
  void operator()(const Set<TerrainSettings>& step) {
    TerrainSettings terrain = step.part;
    terrain.heights = placedHeights(terrain);
    set(m_project.terrain, terrain);
  }
  void operator()(const Set<GrassSettings>& step) {
    GrassSettings grass = step.part;
    keepInStep(grass.densityPixels, grass.densityMap);
    keepInStep(grass.heightPixels, grass.heightMap);
    keepInStep(grass.colourPixels, grass.colourMap);
    set(m_project.grass, grass);
  }

  void operator()(const Set<BezierSettings>& step) { set(m_project.bezier, step.part); }
  void operator()(const Set<ShellSettings>& step) {
    ShellSettings shell = step.part;
    keepInStep(shell.pixels, shell.texture);
    set(m_project.shell, shell);
  }

  void operator()(const EraseSignal& step) {
    erase(m_signals, m_project.graph->signals, [&](const Signal& signal) { return signal.root == step.root; });
  }

  void operator()(const Erase& step) {
    const std::unordered_set<Id> ids(step.ids.begin(), step.ids.end());
    const auto named = [&](const auto& record) { return ids.contains(record.id); };
    erase(m_points, m_project.graph->points, named);
    erase(m_arrows, m_project.graph->arrows,
          [&](const Arrow& a) { return ids.contains(a.id) || ids.contains(a.from) || ids.contains(a.to); });
    erase(m_signals, m_project.graph->signals, [&](const Signal& signal) { return ids.contains(signal.root); });
    erase(m_obstacles, *m_project.obstacles, named);
    erase(m_species, *m_project.species, named);
    erase(m_colliders, *m_project.colliders, named);
    erase(m_surfaces, *m_project.surfaces, named);
    erase(m_rotors, *m_project.rotors, named);
    erase(m_probes, *m_project.probes, named);
    erase(m_cameras, *m_project.cameras, named);
  }

  void operator()(const Reorder& step) {
    const std::unordered_set<Id> ids(step.ids.begin(), step.ids.end());
    const auto move = [&](auto& draft, const auto& part) {
      const auto& records = draft ? draft->records() : part;
      const bool has = std::ranges::any_of(records, [&](const auto& record) { return ids.contains(record.id); });
      const bool here = step.before == 0 ||
                        std::ranges::any_of(records, [&](const auto& record) { return record.id == step.before; });
      if (has && here) list(draft, part).reorder(ids, step.before);
    };
    move(m_points, m_project.graph->points);
    move(m_arrows, m_project.graph->arrows);
    move(m_obstacles, *m_project.obstacles);
    move(m_species, *m_project.species);
    move(m_colliders, *m_project.colliders);
    move(m_surfaces, *m_project.surfaces);
    move(m_rotors, *m_project.rotors);
    move(m_probes, *m_project.probes);
    move(m_cameras, *m_project.cameras);
  }

  Project finish() {
    if (m_points || m_arrows || m_signals) {
      auto graph = std::make_shared<WindGraph>();
      graph->points = m_points ? m_points->take() : m_project.graph->points;
      graph->arrows = m_arrows ? m_arrows->take() : m_project.graph->arrows;
      graph->signals = m_signals ? m_signals->take() : m_project.graph->signals;
      graph->extra = m_project.graph->extra;
      m_project.graph = std::move(graph);
    }
    share(m_obstacles, m_project.obstacles);
    share(m_species, m_project.species);
    share(m_colliders, m_project.colliders);
    share(m_surfaces, m_project.surfaces);
    share(m_rotors, m_project.rotors);
    share(m_probes, m_project.probes);
    share(m_cameras, m_project.cameras);
    return std::move(m_project);
  }

 private:
  template <class Record>
  using List = std::optional<Draft<Record>>;

  template <class Record>
  static Record inStep(Record record) {
    keepInStep(record.mesh, record.file);
    if constexpr (std::is_same_v<Record, Collider>) record.mesh = packedWith(record.mesh, record.spheres);
    return record;
  }
  template <class Record>
  static Draft<Record>& list(List<Record>& draft, const std::vector<Record>& part) {
    return draft ? *draft : draft.emplace(part);
  }
  /// Leaves a part shared where nothing in it goes.
  template <class Record, class Predicate>
  static void erase(List<Record>& draft, const std::vector<Record>& part, Predicate&& goes) {
    if (!draft && std::ranges::none_of(part, goes)) return;
    list(draft, part).erase(goes);
  }
  template <class Record>
  static void share(List<Record>& draft, Shared<std::vector<Record>>& part) {
    if (draft) part = std::make_shared<std::vector<Record>>(draft->take());
  }
  template <class Part>
  static void set(Shared<Part>& part, const Part& value) {
    part = std::make_shared<Part>(value);
  }

  Project m_project;
  List<Point> m_points;
  List<Arrow> m_arrows;
  List<Signal> m_signals;
  List<Obstacle> m_obstacles;
  List<Species> m_species;
  List<Collider> m_colliders;
  List<Surface> m_surfaces;
  List<Rotor> m_rotors;
  List<Probe> m_probes;
  List<Camera> m_cameras;
};

/// An arrow that blows as `model` does; who it is and how it is shown are its own.
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

Point pointAt(Id id, glm::vec2 position) {
  Point point;
  point.id = id;
  point.position = position;
  return point;
}

}  // namespace

Result<Project> applyEdit(const Project& project, const Edit& edit) {
  Editing editing(project);
  for (const EditStep& step : edit.steps) std::visit(editing, step);
  Project result = editing.finish();
  std::vector<Problem> problems = validateChange(result, project);
  if (!problems.empty()) return Error{ErrorKind::BadInput, std::move(problems)};
  return result;
}

Edit moveEdit(const Project& project, std::span<const Id> ids, glm::vec2 delta) {
  const std::unordered_set<Id> moved(ids.begin(), ids.end());
  Edit edit{.label = moved.size() == 1 ? "Move" : "Move " + std::to_string(moved.size()) + " things",
            .steps = {},
            .mergeKey = {}};
  const auto move = [&](const auto& records, auto place) {
    for (const auto& record : records) {
      if (!moved.contains(record.id)) continue;
      auto copy = record;
      copy.*place += delta;
      edit.steps.emplace_back(Put{std::move(copy)});
    }
  };
  move(project.graph->points, &Point::position);
  move(*project.obstacles, &Obstacle::centre);
  move(*project.colliders, &Collider::position);
  move(*project.surfaces, &Surface::position);
  move(*project.rotors, &Rotor::position);
  move(*project.probes, &Probe::position);
  return edit;
}

BranchResult branchEdit(const Project& project, Id from, glm::vec2 position, const Arrow& model) {
  FreeIds ids(project);
  const Id point = ids.take(), arrow = ids.take();
  Edit edit{.label = "Draw branch", .steps = {}, .mergeKey = {}};
  edit.steps.emplace_back(Put<Point>{pointAt(point, position)});
  edit.steps.emplace_back(Put<Arrow>{arrowLike(model, arrow, from, point)});
  return {std::move(edit), point, arrow};
}

TreeResult treeEdit(const Project& project, glm::vec2 start, glm::vec2 end, const Arrow& model) {
  FreeIds ids(project);
  const Id root = ids.take(), tip = ids.take(), arrow = ids.take();
  Edit edit{.label = "Draw tree", .steps = {}, .mergeKey = {}};
  edit.steps.emplace_back(Put<Point>{pointAt(root, start)});
  edit.steps.emplace_back(Put<Point>{pointAt(tip, end)});
  edit.steps.emplace_back(Put<Arrow>{arrowLike(model, arrow, root, tip)});
  return {std::move(edit), root, tip, arrow};
}

Edit eraseEdit(std::vector<Id> ids) {
  std::string label = ids.size() == 1 ? "Delete" : "Delete " + std::to_string(ids.size()) + " things";
  Edit edit{.label = std::move(label), .steps = {}, .mergeKey = {}};
  edit.steps.emplace_back(Erase{std::move(ids)});
  return edit;
}

}  // namespace windloom
