#pragma once
// What is selected: ids in the order they were picked. Not part of the project and not undone, but
// repaired when an undo takes away what was selected.

#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include "engine/model/project.hpp"

namespace windloom::editor {

class Selection {
 public:
  [[nodiscard]] std::span<const Id> ids() const { return m_ids; }
  [[nodiscard]] bool empty() const { return m_ids.empty(); }
  [[nodiscard]] std::size_t size() const { return m_ids.size(); }
  [[nodiscard]] bool contains(Id id) const { return m_set.contains(id); }
  /// The one picked last, 0 where nothing is selected.
  [[nodiscard]] Id active() const { return m_ids.empty() ? 0 : m_ids.back(); }

  void replace(std::vector<Id> ids);  ///< duplicates are dropped
  void replace(Id id) { replace(std::vector<Id>{id}); }
  void add(Id id);  ///< also makes it the active one
  void toggle(Id id);
  void remove(Id id);
  void clear() { replace(std::vector<Id>{}); }

  /// Drops ids that the project doesn't have. True where something was dropped.
  bool repair(const Project& project);

 private:
  std::vector<Id> m_ids;
  std::unordered_set<Id> m_set;  // the same ids
};

/// How a pick combines with what is selected.
enum class SelectMode { Replace, Add, Toggle };
void select(Selection& selection, std::span<const Id> ids, SelectMode mode);

/// Every id of points, arrows, obstacles, colliders, surfaces, rotors and probes that isn't hidden or locked (species
/// and cameras are no things in the view).
std::vector<Id> selectableIds(const Project& project);
/// The ids and everything joined to them by arrows.
std::vector<Id> linkedIds(const Project& project, std::span<const Id> ids);
/// "Arrow 11", "Point 1 (gate)", "3 points, 2 arrows", "" for nothing.
std::string describeIds(const Project& project, std::span<const Id> ids);

}  // namespace windloom::editor
