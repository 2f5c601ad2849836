#include "engine/bake/work_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <utility>

namespace windloom {
namespace fs = std::filesystem;

Result<WorkFolder> WorkFolder::create(const fs::path& parent) {
  std::string name = (parent / ".bake.XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) {
    return makeError(ErrorKind::Machine, parent.string(), {}, std::string("can't write here: ") + std::strerror(errno));
  }
  return WorkFolder(name);
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  if (!m_path.empty()) fs::remove_all(m_path, ignored);
}

WorkFolder::WorkFolder(WorkFolder&& other) noexcept : m_path(std::exchange(other.m_path, {})) {}

Status syncFiles(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const int code = descriptor < 0 || ::syncfs(descriptor) != 0 ? errno : 0;
  if (descriptor >= 0) ::close(descriptor);
  if (code == 0) return Done{};
  return makeError(ErrorKind::Machine, folder.string(), {}, std::string("can't write: ") + std::strerror(code));
}

MadeFolders::MadeFolders(const fs::path& folder) {
  std::error_code ec;
  for (fs::path path = fs::absolute(folder, ec); !path.empty() && !fs::exists(path, ec); path = path.parent_path())
    m_absent.push_back(path);
}

MadeFolders::~MadeFolders() {
  std::error_code ignored;
  for (const fs::path& path : m_absent) {
    if (fs::is_directory(path, ignored)) fs::remove(path, ignored);  // refuses one that holds anything
  }
}

Result<FolderLock> FolderLock::take(const fs::path& folder, const std::function<bool()>& keepWaiting) {
  // The folder itself is locked, so no lock file stays behind.
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  int locked = -1;
  if (descriptor >= 0) {
    locked = ::flock(descriptor, LOCK_EX | LOCK_NB);
    while (locked != 0 && (errno == EWOULDBLOCK || errno == EINTR)) {
      if (!keepWaiting()) {
        ::close(descriptor);
        return FolderLock(-1);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      locked = ::flock(descriptor, LOCK_EX | LOCK_NB);
    }
  }
  if (locked == 0) return FolderLock(descriptor);
  const int code = errno;
  if (descriptor >= 0) ::close(descriptor);
  return makeError(ErrorKind::Machine, folder.string(), {}, std::string("can't be locked: ") + std::strerror(code));
}

FolderLock::~FolderLock() {
  if (m_descriptor >= 0) ::close(m_descriptor);
}

FolderLock::FolderLock(FolderLock&& other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1)) {}

}  // namespace windloom
