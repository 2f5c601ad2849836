#pragma once
// What the editor remembers between runs: a small JSON file. The app says where it lies.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/io/file_access.hpp"

namespace windloom::editor {

enum class Theme { Dark, Light };

struct Preferences {
  Theme theme = Theme::Dark;
  float interfaceScale = 0;               ///< 0: from the monitor; else 0.5..4
  std::vector<std::string> recentFiles;   ///< newest first, at most kMaxRecent, each once
  std::string keymap = "{}";              ///< JSON object for ActionTable::applyKeymap
  std::map<std::string, double> numbers;  ///< whatever a panel wants to remember: "layout.leftWidth", "view.overlays"
  std::map<std::string, std::string> texts;  ///< the same for words: "export.preset"
  /// Folders whose projects may have files read that lie outside them, links followed; at most kMaxTrusted, the oldest
  /// go first.
  std::vector<std::string> outsideAllowed;
  bool firstRunHintSeen = false;

  [[nodiscard]] double number(const std::string& name, double fallback) const;
  [[nodiscard]] std::string text(const std::string& name, const std::string& fallback) const;
  void usedFile(const std::filesystem::path& path);  ///< puts it first in recentFiles
  void forgetFile(const std::filesystem::path& path);
  /// Of the folder of a project file. Ask the file system.
  [[nodiscard]] OutsideFiles outsideFor(const std::filesystem::path& projectFile) const;
  void setOutside(const std::filesystem::path& projectFile, OutsideFiles outside);
};
inline constexpr std::size_t kMaxRecent = 12;
inline constexpr std::size_t kMaxTrusted = 200;
inline constexpr std::uint64_t kMaxPreferencesBytes = 4u << 20;

/// Reads as much as it can: a missing or broken file gives the defaults, wrong values their default.
/// `warnings` gets a line for each thing that was not understood (not for a missing file).
Preferences readPreferences(const std::filesystem::path& path, std::vector<std::string>* warnings = nullptr);
/// Atomic; makes the folder.
Status writePreferences(const std::filesystem::path& path, const Preferences& preferences);

}  // namespace windloom::editor
