#pragma once
// A file written piece by piece that appears under its name only when it is whole. For bytes that are
// all in memory see engine/core/file.hpp.
//
// Until then it is a hidden file beside its place, ".NAME.XXXXXX.windloom" (six letters or digits), locked by its
// writer. A writer that was killed leaves it; the next whole file that is written to the same place by
// writeFileAtomically removes those that nobody holds any more.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/file.hpp"
#include "engine/core/result.hpp"

namespace windloom {

/// Whether a finished file must survive a loss of power at once. Later: whoever makes many files syncs them together
/// before they count, which is much quicker.
enum class Sync { Now, Later };

/// What becomes of a link that stands at the path: it stays, and the file that it names is replaced, or it is replaced.
enum class Links { Follow, Replace };

class AtomicFile {
 public:
  /// Opens a temporary file in the folder of `path`, which must exist. Without `mode` the access rights of an older
  /// file are kept, and a new one's are newFileMode(). Fails with Machine, also where something stands at `path` that
  /// is no regular file or may not be written.
  static Result<AtomicFile> create(const std::filesystem::path& path, std::optional<unsigned> mode = {},
                                   Links links = Links::Follow);
  /// Without finish(), nothing stays on disk.
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;

  /// Appends. Fails with Machine (disk full); the file is then given up and later calls fail too.
  Status write(std::string_view bytes);

  /// Replaces bytes that were written, `at` bytes from the start: headers of what was not known before. What is written
  /// later is appended as before. Fails as write() does.
  Status overwrite(std::uint64_t at, std::string_view bytes);

  /// Syncs the file, renames it over `path` and syncs the folder. With KeepOne the older file is kept as "PATH.bak";
  /// where that can't be, it is logged: newer work counts more. Fails with Machine, leaving an older file as it was.
  Status finish(Sync sync = Sync::Now, Backup backup = Backup::None);

 private:
  AtomicFile() = default;
  void abandon();
  [[nodiscard]] Error failure(int code) const;

  std::filesystem::path m_path, m_target;  // as it was named; with links followed
  std::string m_temporary;
  int m_descriptor = -1;
};

/// A whole file, as AtomicFile writes it, for Sync::Later.
Status writeFileUnsynced(const std::filesystem::path& path, std::string_view bytes);

/// Removes what killed writers left of any file in a folder that is ours alone: hidden temporary files of this user
/// that nobody has locked. What else lies there is left alone.
void clearLeftTemporaries(const std::filesystem::path& folder);

/// Makes finished renames, new and removed names in the folder survive a loss of power. A file system that can't is no
/// failure. Fails with Machine (the disk is broken).
Status syncFolder(const std::filesystem::path& folder);

}  // namespace windloom
