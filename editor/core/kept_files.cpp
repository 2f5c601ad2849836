#include "editor/core/kept_files.hpp"

#include <unistd.h>

#include <cerrno>

#include "engine/core/file.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;

std::string whyKept(const fs::path& file) {
  if (file.empty()) return {};
  std::error_code failed;
  const fs::path path = fs::absolute(file, failed).lexically_normal();
  if (failed) return {};
  const std::string name = path.filename().string();
  // By name, not by what links lead to: a sample opened in its source folder is that folder's business.
  if (const auto samples = findDataFolder("projects")) {
    const fs::path below = path.lexically_relative(fs::absolute(*samples, failed).lexically_normal());
    if (!below.empty() && *below.begin() != "..") {
      return fs::exists(path, failed) ? name + " is a sample and stays as it is."
                                      : path.parent_path().string() + " holds samples and is not written to.";
    }
  }
  const fs::path folder = path.parent_path();
  if (::access(folder.c_str(), W_OK) != 0 && (errno == EACCES || errno == EROFS))
    return folder.string() + " may not be written to.";
  return {};
}

}  // namespace windloom::editor
