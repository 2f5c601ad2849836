#pragma once
// Where the files of a bake come into being.

#include <filesystem>

#include "engine/core/result.hpp"

namespace windloom {

/// A folder inside `parent` that is removed with all that is in it.
class WorkFolder {
 public:
  /// Fails with Machine.
  static Result<WorkFolder> create(const std::filesystem::path& parent);
  ~WorkFolder();
  WorkFolder(WorkFolder&& other) noexcept;
  WorkFolder& operator=(WorkFolder&&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

 private:
  explicit WorkFolder(std::filesystem::path path) : m_path(std::move(path)) {}
  std::filesystem::path m_path;
};

/// Brings all that was written where `folder` lies to the disk, in one go: files that were finished with Sync::Later.
/// Fails with Machine (the disk is full or broken).
Status syncFiles(const std::filesystem::path& folder);

/// Holds a folder for itself until it goes: programs that finish parts of one bake come one after the other.
class FolderLock {
 public:
  /// Waits for another program that has it. Fails with Machine.
  static Result<FolderLock> take(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&&) = delete;

 private:
  explicit FolderLock(int descriptor) : m_descriptor(descriptor) {}
  int m_descriptor = -1;
};

}  // namespace windloom
