#include "editor/app/user_folders.hpp"

#include <cstdlib>

namespace windloom::editor {
namespace {

/// $VARIABLE/windloom, or windloom in the fallback below the home folder.
std::filesystem::path userFolder(const char* variable, const char* fallback) {
  if (const char* set = std::getenv(variable); set && set[0] != 0) return std::filesystem::path(set) / "windloom";
  const char* home = std::getenv("HOME");
  return std::filesystem::path(home ? home : ".") / fallback / "windloom";
}

}  // namespace

std::filesystem::path configFolder() {
  return userFolder("XDG_CONFIG_HOME", ".config");
}

std::filesystem::path stateFolder() {
  return userFolder("XDG_STATE_HOME", ".local/state");
}

}  // namespace windloom::editor
