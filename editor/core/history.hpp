#pragma once
// Undo and redo: a list of project values. Entry 0 is the project as opened; each entry is the project
// after an edit. Shared parts are counted once, so 200 steps of a large project cost what changed.

#include <cstddef>
#include <string>
#include <vector>

#include "engine/model/project.hpp"

namespace windloom::editor {

struct HistoryLimits {
  std::size_t bytes = 256u << 20;  ///< parts of all entries together
  std::size_t keepSteps = 200;     ///< so many undo steps stay even where they exceed `bytes`
  std::size_t maxSteps = 2000;
};

class History {
 public:
  explicit History(Project start, HistoryLimits limits = {});

  struct Entry {
    std::string label = {};  ///< of the edit that led here; "Open" for the first
    Project project = {};
    std::string mergeKey = {};
    std::size_t addedBytes = 0;  ///< memory of the parts that the entry before doesn't share
  };

  [[nodiscard]] const Project& current() const { return m_entries[m_at].project; }
  [[nodiscard]] const std::vector<Entry>& entries() const { return m_entries; }
  [[nodiscard]] std::size_t position() const { return m_at; }  ///< index of the current entry

  /// Drops what could be redone and appends; with the non-empty merge key of the current entry it replaces
  /// that entry's project instead, unless the history was sealed, saved or undone since.
  void push(Project project, std::string label, std::string mergeKey = {});
  /// The next push starts a new entry whatever its merge key (a slider was let go).
  void seal() { m_sealed = true; }

  [[nodiscard]] bool canUndo() const { return m_at > 0; }
  [[nodiscard]] bool canRedo() const { return m_at + 1 < m_entries.size(); }
  bool undo();  ///< false: nothing to undo
  bool redo();
  /// Goes to an entry of entries(); out of range does nothing and gives false.
  bool jump(std::size_t index);

  void markSaved() {
    m_saved = current();
    m_sealed = true;
  }
  /// Whether the current project differs from the one last saved. Undoing back to it makes it clean again.
  [[nodiscard]] bool dirty() const { return !m_saved.sameAs(current()); }
  /// Nothing on disk equals this project (a recovered or new one from a template).
  void markUnsaved();

  /// Memory of all entries' parts, each part counted once.
  [[nodiscard]] std::size_t bytes() const;

 private:
  void trim();
  std::vector<Entry> m_entries;
  std::size_t m_at = 0;
  bool m_sealed = false;
  Project m_saved;
  HistoryLimits m_limits;
};

}  // namespace windloom::editor
