#pragma once
// Where the editor keeps what isn't the user's work, after the XDG base directory specification.

#include <filesystem>

namespace windloom::editor {

/// Preferences: $XDG_CONFIG_HOME/windloom, else ~/.config/windloom.
std::filesystem::path configFolder();
/// Side files of autosave and the log: $XDG_STATE_HOME/windloom, else ~/.local/state/windloom.
std::filesystem::path stateFolder();

}  // namespace windloom::editor
