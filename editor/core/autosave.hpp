#pragma once
// Autosave to a side file, never over the user's file, and what to do with it after a crash.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "editor/core/document.hpp"

namespace windloom::editor {

inline constexpr int kAutosaveEdits = 25;
inline constexpr double kAutosaveSeconds = 120;

/// Side files lie in a folder of the app's choice, one for each running editor.
class Autosave {
 public:
  /// `session` makes the file name unique (a process id).
  Autosave(std::filesystem::path folder, std::string session);

  /// Call once a frame with a steadily growing time. Writes the side file when 25 edits were made since the
  /// last write, or 2 minutes passed since the first edit after it; removes it once the document is clean.
  Status tick(const Document& document, double nowSeconds);
  /// The editor closes in order: the side file goes.
  void finish();
  [[nodiscard]] const std::filesystem::path& sideFile() const { return m_file; }

 private:
  std::filesystem::path m_folder, m_file;
  std::uint64_t m_seenRevision = 0;
  int m_edits = 0;
  std::optional<double> m_firstEditAt;
  Project m_written;
  bool m_exists = false;
};

/// A side file that a crashed editor left.
struct Rescue {
  std::filesystem::path sideFile;
  std::filesystem::path original;  ///< the user's file; empty where it was never saved
  std::string savedAt;             ///< local time, "2025-03-01 14:05"
};
/// Side files in the folder whose editor no longer runs, newest first.
std::vector<Rescue> findRescues(const std::filesystem::path& folder);
/// Takes it into the document (dirty). On failure the document stays.
Status restoreRescue(Document& document, const Rescue& rescue);
void discardRescue(const Rescue& rescue);
/// What differs between the user's file and the side file, one line each: "2 arrows added", "Point 3 moved".
std::vector<std::string> describeRescue(const Rescue& rescue);
/// The differences between two projects in words.
std::vector<std::string> describeChanges(const Project& before, const Project& after);

}  // namespace windloom::editor
