#pragma once
// Where the files of a bake come into being.

#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

#include "engine/core/result.hpp"

namespace windloom {

/// A folder inside `parent`, ".bake.windloom.XXXXXX", that is removed with all that is in it. It is locked as long as
/// this lives, so that others can tell it from one whose program was killed.
class WorkFolder {
 public:
  /// Fails with Machine.
  static Result<WorkFolder> create(const std::filesystem::path& parent);
  ~WorkFolder();
  WorkFolder(WorkFolder&& other) noexcept;
  WorkFolder& operator=(WorkFolder&&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

 private:
  friend std::vector<WorkFolder> leftWorkFolders(const std::filesystem::path& parent);
  WorkFolder(std::filesystem::path path, int lock) : m_path(std::move(path)), m_lock(lock) {}
  std::filesystem::path m_path;
  int m_lock = -1;
};

/// Work folders of this user in `parent` whose programs no longer run. Nothing where the file system knows no locks.
std::vector<WorkFolder> leftWorkFolders(const std::filesystem::path& parent);

/// Brings all that was written where `folder` lies to the disk, in one go: files that were finished with Sync::Later.
/// Fails with Machine (the disk is full or broken).
Status syncFiles(const std::filesystem::path& folder);

/// A folder and not a link to one: behind a link lies what isn't of the bake.
bool isRealFolder(const std::filesystem::path& path);

/// Remembers which parents of a folder, and the folder, weren't there; when it goes, removes those that are empty. So a
/// bake that fails leaves no empty folders.
class MadeFolders {
 public:
  explicit MadeFolders(const std::filesystem::path& folder);
  ~MadeFolders();
  MadeFolders(const MadeFolders&) = delete;
  MadeFolders& operator=(const MadeFolders&) = delete;

 private:
  std::vector<std::filesystem::path> m_absent;  // the innermost first
};

/// Holds a folder for itself until it goes: programs that finish parts of one bake come one after the other.
class FolderLock {
 public:
  /// Waits for another program that has it, as long as `keepWaiting` says so; then it is not held(). Fails with
  /// Machine.
  static Result<FolderLock> take(const std::filesystem::path& folder, const std::function<bool()>& keepWaiting);
  [[nodiscard]] bool held() const { return m_descriptor >= 0; }
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  explicit FolderLock(int descriptor) : m_descriptor(descriptor) {}
  int m_descriptor = -1;
};

}  // namespace windloom
