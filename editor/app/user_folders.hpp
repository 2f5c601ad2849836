#pragma once
// Where the editor keeps what isn't the user's work, after the XDG base directory specification. The home folder is
// that of $HOME, else that of the password database; paths that aren't absolute don't count. Where there is none, all
// are empty: never is anything read from or written to the folder that the editor happens to be started in.

#include <filesystem>

namespace windloom::editor {

/// $XDG_CONFIG_HOME/windloom/preferences.json, else below ~/.config.
std::filesystem::path preferencesFile();
/// The log: $XDG_STATE_HOME/windloom, else below ~/.local/state.
std::filesystem::path stateFolder();
/// Side files of autosave: in the state folder.
std::filesystem::path autosaveFolder();

}  // namespace windloom::editor
