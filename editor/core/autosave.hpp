#pragma once
// Autosave to a side file, never over the user's file, and what to do with it after a crash.

#include <cstdint>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "editor/core/document.hpp"
#include "editor/core/project_changes.hpp"
#include "engine/io/project_json.hpp"

namespace windloom::editor {

// A crash may cost at most 25 edits or 2 minutes: begun a little earlier, a write has its own time in that, too.
inline constexpr std::uint64_t kAutosaveEdits = 20;
inline constexpr double kAutosaveSeconds = 110;
/// Of a side file. Escaped as a text, a project takes more room than as a file.
inline constexpr std::uint64_t kMaxRescueBytes = 4 * kMaxProjectBytes;

/// Writes side files into a folder of the app's choice, one for each running editor, on a thread of its own: a slow
/// disk doesn't hold up a frame. A lock file beside it, held while this lives, tells other editors that its owner runs.
class Autosave {
 public:
  /// `session` makes the file name unique (a process id); a name that is taken gets a number. Folder and files are for
  /// their owner alone. An empty folder means none: tick() does nothing, writeNow() fails.
  Autosave(std::filesystem::path folder, std::string session);
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Call once a frame with a steadily growing time. Begins to write the side file when kAutosaveEdits edits were
  /// made since the last write, or kAutosaveSeconds passed since the first edit after it; removes it once the
  /// document is clean. A rescued project is written at once; the side file that it came from goes when that is
  /// done, and so it does on a save. A write that failed (disk full) is told by the next tick, once; it is tried
  /// again after as many edits or as much time.
  Status tick(const Document& document, double nowSeconds);
  /// Writes the side file on this thread, before it returns, whatever tick() would do: memory has ended, the screen is
  /// lost, the program is about to end. To be called on the window's thread, at any time. Waits for a write under way,
  /// gives memory back that was kept for this, and never throws. A document without changes needs none and is Done.
  Status writeNow(const Document& document) noexcept;
  /// Waits for a write that is under way.
  Status wait();
  /// The editor closes in order: the side file goes.
  void finish();
  [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }
  [[nodiscard]] const std::filesystem::path& sideFile() const { return m_file; }

 private:
  struct Writing {
    std::future<Status> done;
    std::filesystem::path rescuedFrom;  // of the project that is written
    bool stale = false;                 // the user's own file became newer meanwhile
  };
  void claimFile();
  void begin(const Document& document);
  void keepReserve();
  Status writeHere(const Document& document);
  Status take();
  void removeFile();
  void dropRescued(const std::filesystem::path& rescued);

  std::filesystem::path m_folder;
  std::string m_session;
  std::filesystem::path m_file, m_lockFile;  // empty where none could be made yet
  int m_lock = -1;
  Writing m_writing;
  std::filesystem::path m_seenRescue, m_dropped;  // rescued side files: met, and removed
  std::optional<std::uint64_t> m_writtenEdits;    // the document's count when it was last clean or written
  std::optional<double> m_firstEditAt;
  bool m_exists = false;
  std::unique_ptr<char[]> m_reserve;  // given back when memory has ended, so that there is some to write with
  Error m_lastWord;                   // what to say where there is not even memory for words
};

/// A side file that a crashed editor left.
struct Rescue {
  std::filesystem::path sideFile;
  std::filesystem::path original;  ///< the user's file; empty where it was never saved
  std::string savedAt;             ///< local time, "2025-03-01 14:05"
};
/// Side files in the folder whose editor no longer runs, newest first. Files that are none are left alone.
std::vector<Rescue> findRescues(const std::filesystem::path& folder);
/// Takes it into the document (dirty). On failure the document stays. The side file stays until Autosave has
/// written its own or the project is saved.
Status restoreRescue(Document& document, const Rescue& rescue, OutsideFiles outside = OutsideFiles::Refuse);
/// Removes the side file: the user doesn't want it.
void discardRescue(const Rescue& rescue);
/// What differs between the user's file and the side file, one line each; the reason where either can't be read.
std::vector<std::string> describeRescue(const Rescue& rescue);

}  // namespace windloom::editor
