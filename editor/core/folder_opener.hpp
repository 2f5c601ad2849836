#pragma once
// Shows a folder in the desktop's file manager: runs xdg-open beside the editor, without a shell.

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "engine/core/result.hpp"

namespace windloom::editor {

class FolderOpener {
 public:
  /// Doesn't wait. Fails with Machine where xdg-open is not installed or no process can be made.
  Status open(const std::filesystem::path& folder);
  /// Once a frame: what went wrong with one that had started, once.
  std::optional<Error> poll();

 private:
  /// On some desktops xdg-open ends only when the file manager does, so there may be several.
  struct Child {
    pid_t process = 0;
    std::filesystem::path folder;
  };
  std::vector<Child> m_children;
};

}  // namespace windloom::editor
