#include "editor/core/history.hpp"

#include <map>

namespace windloom::editor {
namespace {

/// Short texts lie inside the string itself.
std::size_t heapOf(const std::string& text) {
  return text.capacity() >= sizeof(std::string) / 2 ? text.capacity() : 0;
}

template <class T>
std::size_t bytesOf(const T& settings) {
  return sizeof settings + heapOf(settings.extra);
}
std::size_t bytesOf(const std::string& text) {
  return sizeof text + heapOf(text);
}
template <class T>
std::size_t bytesOf(const std::vector<T>& records) {
  std::size_t bytes = sizeof records + records.capacity() * sizeof(T);
  for (const T& record : records) bytes += heapOf(record.name) + heapOf(record.extra);
  return bytes;
}
template <>
std::size_t bytesOf(const std::vector<Collider>& colliders) {
  std::size_t bytes = sizeof colliders + colliders.capacity() * sizeof(Collider);
  for (const Collider& c : colliders)
    bytes += heapOf(c.name) + heapOf(c.extra) + heapOf(c.file) + c.keys.capacity() * sizeof(ColliderKey);
  return bytes;
}
std::size_t bytesOf(const WindGraph& graph) {
  std::size_t bytes = bytesOf(graph.points) + bytesOf(graph.arrows) + graph.signals.capacity() * sizeof(Signal) +
                      sizeof graph + heapOf(graph.extra);
  for (const Signal& signal : graph.signals) {
    bytes += heapOf(signal.extra) + signal.keys.capacity() * sizeof(SignalKey);
  }
  return bytes;
}

std::size_t bytesOf(const PlantMesh& mesh) {
  return sizeof mesh + mesh.vertices.capacity() * sizeof(PlantVertex) +
         mesh.indices.capacity() * sizeof(std::uint32_t) + mesh.texture.capacity() +
         mesh.spheres.capacity() * sizeof(glm::vec4);
}
std::size_t bytesOf(const GrassMap& map) {
  return sizeof map + map.pixels.capacity();
}

/// What a project's files were read into, each once.
std::map<const void*, std::size_t> filesOf(const Project& project) {
  std::map<const void*, std::size_t> files;
  const auto add = [&](const auto& read) {
    if (read) files.emplace(read.get(), bytesOf(*read));
  };
  for (const Species& species : *project.species) add(species.mesh);
  for (const Collider& collider : *project.colliders) add(collider.mesh);
  for (const Surface& surface : *project.surfaces) add(surface.mesh);
  add(project.grass->densityPixels);
  add(project.grass->heightPixels);
  add(project.grass->colourPixels);
  add(project.shell->pixels);
  if (project.terrain->heights) {
    const auto& source = project.terrain->heights->source;
    files.emplace(source.get(), source->values.capacity() * sizeof(float));
  }
  return files;
}

/// Memory of the parts that `before` (may be null) doesn't share. An entry is always made from the one
/// before it, so a part lives in a run of entries and is counted where the run begins.
std::size_t partBytes(const Project* before, const Project& project) {
  std::size_t bytes = sizeof(History::Entry) + heapOf(project.name);
  const auto add = [&](auto Project::*part) {
    if (!before || before->*part != project.*part) bytes += bytesOf(*(project.*part));
  };
  add(&Project::field);
  add(&Project::solver);
  add(&Project::ambient);
  add(&Project::graph);
  add(&Project::obstacles);
  add(&Project::terrain);
  add(&Project::grass);
  add(&Project::bezier);
  add(&Project::shell);
  add(&Project::species);
  add(&Project::colliders);
  add(&Project::surfaces);
  add(&Project::rotors);
  add(&Project::probes);
  add(&Project::cameras);
  add(&Project::extra);
  // Edits of a record share what was read from its file.
  const auto had = before ? filesOf(*before) : std::map<const void*, std::size_t>();
  for (const auto& [file, size] : filesOf(project)) {
    if (!had.contains(file)) bytes += size;
  }
  return bytes;
}

}  // namespace

History::History(Project start, HistoryLimits limits) : m_saved(start), m_limits(limits) {
  const std::size_t bytes = partBytes(nullptr, start);
  m_entries.push_back({"Open", std::move(start), {}, bytes});
}

void History::push(Project project, std::string label, std::string mergeKey) {
  const bool merges = !mergeKey.empty() && !m_sealed && m_at > 0 && !canRedo() && m_entries[m_at].mergeKey == mergeKey;
  if (merges) {
    Entry& entry = m_entries[m_at];
    entry.project = std::move(project);
    entry.addedBytes = partBytes(&m_entries[m_at - 1].project, entry.project);
    return;
  }
  m_entries.resize(m_at + 1);
  const std::size_t bytes = partBytes(&m_entries[m_at].project, project);
  m_entries.push_back({std::move(label), std::move(project), std::move(mergeKey), bytes});
  ++m_at;
  m_sealed = false;
  trim();
}

bool History::undo() {
  return canUndo() && jump(m_at - 1);
}
bool History::redo() {
  return canRedo() && jump(m_at + 1);
}

bool History::jump(std::size_t index) {
  if (index >= m_entries.size()) return false;
  m_at = index;
  m_sealed = true;
  return true;
}

void History::markUnsaved() {
  // A graph pointer that no entry can have.
  m_saved.graph = std::make_shared<WindGraph>();
  m_sealed = true;
}

std::size_t History::bytes() const {
  std::size_t sum = 0;
  for (const Entry& entry : m_entries) sum += entry.addedBytes;
  return sum;
}

void History::trim() {
  std::size_t sum = bytes();
  const auto overfull = [&] {
    const std::size_t steps = m_entries.size() - 1;
    return steps > m_limits.maxSteps || (sum > m_limits.bytes && steps > m_limits.keepSteps);
  };
  while (overfull()) {
    // The second entry becomes the first and has to bear all its parts.
    const std::size_t whole = partBytes(nullptr, m_entries[1].project);
    sum = sum - m_entries[0].addedBytes - m_entries[1].addedBytes + whole;
    m_entries[1].addedBytes = whole;
    m_entries.erase(m_entries.begin());
    --m_at;
  }
}

}  // namespace windloom::editor
