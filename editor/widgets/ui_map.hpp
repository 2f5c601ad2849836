#pragma once
// Where things are on the screen, by name: `windloom-editor --ui-map FILE` keeps that file up to date, so that
// window tests and accessibility tools find a button without guessing pixels. Costs nothing when it is off.

#include <imgui.h>

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace windloom::editor {

class UiMap {
 public:
  /// Turns it on. The file is replaced atomically whenever what it says changes.
  void setFile(std::filesystem::path file) { m_file = std::move(file); }
  [[nodiscard]] bool on() const { return !m_file.empty(); }

  /// A rectangle of this frame, in window pixels from the top left corner.
  void rectangle(std::string_view name, ImVec2 min, ImVec2 max);
  /// A fact of this frame: window title, dialog shown, number of undo steps ... Line breaks are written as "\n".
  void fact(std::string_view name, std::string_view value);

  /// Writes the file where this frame differs from the last, and starts the next frame.
  void endFrame();

 private:
  std::filesystem::path m_file;
  std::map<std::string, std::string, std::less<>> m_facts, m_rectangles;
  std::string m_written;
};

}  // namespace windloom::editor
