#include "engine/bake/work_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "engine/core/file.hpp"
#include "engine/core/log.hpp"

namespace windloom {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kPrefix = ".bake.windloom.", kPlaces = "XXXXXX";
constexpr int kAttempts = 20;

int openFolder(const fs::path& folder) {
  return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

/// Whether it is still the folder of that name.
bool isStill(int folder, const std::string& name) {
  struct stat here {
  }, there{};
  return ::fstat(folder, &here) == 0 && ::lstat(name.c_str(), &there) == 0 && here.st_ino == there.st_ino;
}

}  // namespace

Result<WorkFolder> WorkFolder::create(const fs::path& parent) {
  int code = EAGAIN;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::string name = (parent / (std::string(kPrefix) + std::string(kPlaces))).string();
    if (::mkdtemp(name.data()) == nullptr) {
      code = errno;
      break;
    }
    // Another bake may have met it before it was locked, and cleared it away.
    const int folder = openFolder(name);
    const bool locked = folder >= 0 && ::flock(folder, LOCK_EX) == 0;
    if (!locked || isStill(folder, name)) return WorkFolder(name, folder);
    ::close(folder);
  }
  return makeError(ErrorKind::Machine, parent.string(), {}, std::string("can't write here: ") + std::strerror(code));
}

WorkFolder::~WorkFolder() {
  std::error_code ignored;
  if (!m_path.empty()) fs::remove_all(m_path, ignored);
  if (m_lock >= 0) ::close(m_lock);
}

WorkFolder::WorkFolder(WorkFolder&& other) noexcept
    : m_path(std::exchange(other.m_path, {})), m_lock(std::exchange(other.m_lock, -1)) {}

std::vector<WorkFolder> leftWorkFolders(const fs::path& parent) {
  std::vector<WorkFolder> left;
  std::error_code failed;
  for (fs::directory_iterator it(parent, failed), end; !failed && it != end; it.increment(failed)) {
    const std::string name = it->path().filename().string();
    if (!name.starts_with(kPrefix) || name.size() != kPrefix.size() + kPlaces.size()) continue;
    const int folder = openFolder(it->path());
    if (folder < 0) continue;
    struct stat found {};
    const bool ours = ::fstat(folder, &found) == 0 && found.st_uid == ::geteuid();
    if (ours && ::flock(folder, LOCK_EX | LOCK_NB) == 0) {
      left.push_back(WorkFolder(it->path(), folder));
    } else {
      ::close(folder);
    }
  }
  return left;
}

Status syncFiles(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const int code = descriptor < 0 || ::syncfs(descriptor) != 0 ? errno : 0;
  if (descriptor >= 0) ::close(descriptor);
  if (code == 0) return Done{};
  return makeError(ErrorKind::Machine, folder.string(), {}, std::string("can't write: ") + std::strerror(code));
}

bool isRealFolder(const fs::path& path) {
  std::error_code ec;
  return fs::is_directory(fs::symlink_status(path, ec));
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

namespace {

/// 0 once it is locked, ECANCELED where nobody would wait any longer, else why it can't be.
int lockWaiting(int descriptor, const std::function<bool()>& keepWaiting) {
  while (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK) return errno;
    if (!keepWaiting()) return ECANCELED;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return 0;
}

bool meansNoLocks(int code) {
  return code == EBADF || code == EINVAL || code == ENOLCK || code == ENOSYS || code == EOPNOTSUPP;
}

}  // namespace

Result<FolderLock> FolderLock::take(const fs::path& folder, const std::function<bool()>& keepWaiting) {
  // The folder itself is locked, so no lock file stays behind. Network file systems lock only what is open for
  // writing, which a folder can't be: there a file stays.
  int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  int code = descriptor < 0 ? errno : lockWaiting(descriptor, keepWaiting);
  if (descriptor >= 0 && meansNoLocks(code)) {
    ::close(descriptor);
    constexpr int how = O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
    descriptor = ::open((folder / ".bake.windloom.lock").c_str(), how, newFileMode());
    code = descriptor < 0 ? errno : lockWaiting(descriptor, keepWaiting);
    if (descriptor >= 0 && meansNoLocks(code)) {
      logWarning(folder.string() + " can't be locked here: only one bake at a time may write into it");
      return FolderLock(descriptor);
    }
  }
  if (code == 0) return FolderLock(descriptor);
  if (descriptor >= 0) ::close(descriptor);
  if (code == ECANCELED) return FolderLock(-1);
  return makeError(ErrorKind::Machine, folder.string(), {}, std::string("can't be locked: ") + std::strerror(code));
}

FolderLock::~FolderLock() {
  if (m_descriptor >= 0) ::close(m_descriptor);
}

FolderLock::FolderLock(FolderLock&& other) noexcept : m_descriptor(std::exchange(other.m_descriptor, -1)) {}

}  // namespace windloom
