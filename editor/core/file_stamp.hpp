#pragma once
// Tells whether a file is still the one that was read, without reading it again.

#include <cstdint>
#include <filesystem>

namespace windloom::editor {

struct FileStamp {
  bool exists = false;
  std::uint64_t device = 0, inode = 0, bytes = 0;
  std::int64_t changedNs = 0;  ///< when its bytes last changed, since 1970
  bool operator==(const FileStamp&) const = default;
};

/// Of what the path leads to now; without `exists` where there is nothing.
FileStamp stampOf(const std::filesystem::path& path);

}  // namespace windloom::editor
