#pragma once
// Choosing a file: our own window, since the system's dialogs would each need another library.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace windloom::editor {

class FileBrowser {
 public:
  enum class Purpose { Open, Save };

  /// Opens it in the folder of `start` with its file name filled in. `suffix` filters what is listed; several stand
  /// with ; between them.
  void open(Purpose purpose, std::string title, const std::filesystem::path& start, std::string suffix);
  /// A line to read below the list, until another folder is entered; why a file is asked for.
  void explain(std::string text) { m_problem = std::move(text); }
  [[nodiscard]] bool isOpen() const { return m_open; }

  /// Draws it while it is open. The path, once, when one was chosen.
  std::optional<std::filesystem::path> draw();
  void close() { m_open = false; }

 private:
  struct Entry {
    std::string name;
    bool folder = false;
  };
  void enter(const std::filesystem::path& folder);
  std::optional<std::filesystem::path> accept();
  void drawPlaces();
  std::optional<std::filesystem::path> drawList(float height);

  bool m_open = false, m_justOpened = false;
  Purpose m_purpose = Purpose::Open;
  std::string m_title, m_suffix, m_name, m_problem, m_pathText;
  std::filesystem::path m_folder;
  std::vector<Entry> m_entries;
};

}  // namespace windloom::editor
