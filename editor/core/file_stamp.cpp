#include "editor/core/file_stamp.hpp"

#include <sys/stat.h>

namespace windloom::editor {

FileStamp stampOf(const std::filesystem::path& path) {
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return {};
  constexpr std::int64_t kNsInSecond = 1'000'000'000;
  return {true, static_cast<std::uint64_t>(found.st_dev), static_cast<std::uint64_t>(found.st_ino),
          static_cast<std::uint64_t>(found.st_size), found.st_mtim.tv_sec * kNsInSecond + found.st_mtim.tv_nsec};
}

}  // namespace windloom::editor
