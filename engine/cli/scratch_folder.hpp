#pragma once
// A folder that goes with its scene.

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace windloom::cli {

struct ScratchFolder {
  std::filesystem::path path;  ///< empty where none could be made
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "windloom-bench-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    if (!path.empty()) std::filesystem::remove_all(path, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
};

}  // namespace windloom::cli
