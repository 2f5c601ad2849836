#pragma once
// The log: what the program said, newest last.

#include <deque>
#include <mutex>
#include <string>
#include <string_view>

#include "editor/core/log_file.hpp"
#include "engine/core/log.hpp"

namespace windloom::editor {

class LogPanel {
 public:
  /// Takes over every later log message of the program until it is destroyed, and passes it to the file.
  explicit LogPanel(LogFile& file);
  ~LogPanel();
  LogPanel(const LogPanel&) = delete;
  LogPanel& operator=(const LogPanel&) = delete;

  void draw();
  /// Warnings and errors since the panel was last drawn.
  [[nodiscard]] int unread() const { return m_unread; }

 private:
  struct Line {
    LogLevel level = LogLevel::Info;
    std::string text;
  };
  void add(LogLevel level, std::string_view text);
  [[nodiscard]] std::string allText() const;

  mutable std::mutex m_mutex;  // messages come from any thread
  std::deque<Line> m_lines;
  int m_unread = 0;
  bool m_newLines = false;
};

}  // namespace windloom::editor
