#pragma once
// What the editor said, in a file: it is there when somebody wants to tell of a crash.

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "engine/core/log.hpp"

namespace windloom::editor {

/// Lines of all running editors go to one file, log.txt, each with its time and the process. A file beyond
/// kMostLogBytes becomes log.old.txt, in place of the one before: so the two never take more than twice that. Nothing
/// that goes wrong here (no folder, full disk) is told or holds anything up; the lines are then missing.
class LogFile {
 public:
  static constexpr std::uint64_t kMostLogBytes = 512 << 10;

  /// Makes the folder. An empty path: no file is made, add() does nothing.
  explicit LogFile(const std::filesystem::path& folder);
  ~LogFile();
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;

  /// As printableLines gives the text (engine/core/text.hpp), so that every line that isn't indented is one of ours.
  /// Not for two threads at once: a log sink is never called so.
  void add(LogLevel level, std::string_view text);
  /// From here on, a signal that ends the program by a mistake of its own (a bad access, an abort) first leaves a line
  /// with its number and the addresses of the calls. For one log file at a time.
  void catchCrashes();
  [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

 private:
  void open();
  void turnOver();

  std::filesystem::path m_path;
  int m_descriptor = -1;
  std::uint64_t m_bytes = 0;
};

}  // namespace windloom::editor
