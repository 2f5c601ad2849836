#pragma once
// What windloom-editor was called with.

#include <filesystem>
#include <optional>

namespace windloom::editor {

struct CommandLine {
  std::filesystem::path file;        ///< to open; empty: an empty project
  std::optional<int> width, height;  ///< window pixels, from --size
  float scale = 0;                   ///< of the interface, from --scale; 0: preferences
  std::filesystem::path screenshot;  ///< write a picture of the window here after `frames` frames, then end
  int frames = 60;
  std::filesystem::path keys;   ///< write the list of keys here, then end
  std::filesystem::path uiMap;  ///< keep this file up to date with where things are on the screen

  /// Nobody sits before it: preferences are neither read nor written, no unsaved work is offered.
  [[nodiscard]] bool unattended() const { return !screenshot.empty() || !keys.empty(); }
};

/// Nothing where the program is to end at once with `exitStatus`: help, version, wrong usage (2).
std::optional<CommandLine> parseCommandLine(int argc, const char* const* argv, int& exitStatus);

}  // namespace windloom::editor
