#pragma once
// A file written piece by piece that appears under its name only when it is whole. For bytes that are
// all in memory see engine/core/file.hpp.

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/core/result.hpp"

namespace windloom {

/// Whether a finished file must survive a loss of power at once. Later: whoever makes many files syncs them together
/// before they count, which is much quicker.
enum class Sync { Now, Later };

class AtomicFile {
 public:
  /// Opens a temporary file in the folder of `path`, which must exist. Fails with Machine.
  static Result<AtomicFile> create(const std::filesystem::path& path);
  /// Without finish(), nothing stays on disk.
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;

  /// Appends. Fails with Machine (disk full); the file is then given up and later calls fail too.
  Status write(std::string_view bytes);

  /// Replaces bytes that were written, `at` bytes from the start: headers of what was not known before. What is written
  /// later is appended as before. Fails as write() does.
  Status overwrite(std::uint64_t at, std::string_view bytes);

  /// Syncs the file and renames it over `path`. Fails with Machine, leaving an older file as it was.
  Status finish(Sync sync = Sync::Now);

 private:
  AtomicFile() = default;
  void abandon();
  [[nodiscard]] Error failure(int code) const;

  std::filesystem::path m_path;
  std::string m_temporary;
  int m_descriptor = -1;
};

/// A whole file, as AtomicFile writes it, for Sync::Later.
Status writeFileUnsynced(const std::filesystem::path& path, std::string_view bytes);

}  // namespace windloom
