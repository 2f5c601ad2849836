#include "editor/app/user_folders.hpp"

#include <pwd.h>
#include <unistd.h>

#include <cstdlib>

namespace windloom::editor {
namespace fs = std::filesystem;
namespace {

/// Empty where the variable holds no absolute path.
fs::path pathIn(const char* variable) {
  const char* set = std::getenv(variable);
  return set && set[0] == '/' ? fs::path(set) : fs::path();
}

fs::path homeFolder() {
  if (fs::path home = pathIn("HOME"); !home.empty()) return home;
  const passwd* entry = ::getpwuid(::geteuid());
  return entry && entry->pw_dir && entry->pw_dir[0] == '/' ? fs::path(entry->pw_dir) : fs::path();
}

/// $VARIABLE/windloom, or windloom in the fallback below the home folder.
fs::path userFolder(const char* variable, const char* fallback) {
  if (const fs::path set = pathIn(variable); !set.empty()) return set / "windloom";
  const fs::path home = homeFolder();
  return home.empty() ? fs::path() : home / fallback / "windloom";
}

fs::path below(const fs::path& folder, const char* name) {
  return folder.empty() ? fs::path() : folder / name;
}

}  // namespace

fs::path preferencesFile() {
  return below(userFolder("XDG_CONFIG_HOME", ".config"), "preferences.json");
}

fs::path stateFolder() {
  return userFolder("XDG_STATE_HOME", ".local/state");
}

fs::path autosaveFolder() {
  return below(stateFolder(), "autosave");
}

}  // namespace windloom::editor
