#include "engine/core/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <random>
#include <utility>

#include "engine/core/log.hpp"
#include "engine/core/out_of_memory.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPlaces = "XXXXXX", kSuffix = ".windloom";
constexpr std::size_t kLongestName = 255;  // NAME_MAX of the usual file systems
constexpr int kAttempts = 20;

/// A system call once more where a signal came in between.
template <class Call>
auto uninterrupted(Call call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

Error writeError(const fs::path& path, const std::string& reason) {
  return makeError(ErrorKind::Machine, path.string(), {}, "can't write: " + reason);
}

/// What `path` names with links followed, whether that is there or not; empty where links lead nowhere.
fs::path followed(fs::path path) {
  constexpr int kMostLinks = 40;
  std::error_code ec;
  for (int link = 0; link < kMostLinks; ++link) {
    if (!fs::is_symlink(path, ec)) return path;
    const fs::path named = fs::read_symlink(path, ec);
    if (ec) return {};
    path = path.parent_path() / named;  // an absolute name replaces it
  }
  return {};
}

/// What the names of the temporary files of `target` begin with.
std::string prefixOf(const fs::path& target) {
  const std::string name = target.filename().string();
  return std::string(".").append(name, 0, kLongestName - 2 - kPlaces.size() - kSuffix.size()).append(".");
}

/// What a temporary file's name begins with, ".NAME."; empty for any other file.
std::string prefixIn(const std::string& name) {
  constexpr std::size_t kRest = kPlaces.size() + kSuffix.size();
  if (name.size() < kRest + 3 || !name.starts_with(".") || !name.ends_with(kSuffix)) return {};
  const std::string prefix = name.substr(0, name.size() - kRest);
  const std::string_view places = std::string_view(name).substr(prefix.size(), kPlaces.size());
  const bool random = std::ranges::all_of(places, [](unsigned char c) { return std::isalnum(c) != 0; });
  return random && prefix.ends_with(".") ? prefix : std::string();
}

/// A new file beside `target`, open and locked; its name goes to `name`. -1 where it can't be made: errno says why.
int makeTemporary(const fs::path& target, std::string& name) {
  const std::string wanted = (target.parent_path() / (prefixOf(target) + std::string(kPlaces))).string();
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    name = wanted + std::string(kSuffix);
    const int made =
        uninterrupted([&] { return ::mkostemps(name.data(), static_cast<int>(kSuffix.size()), O_CLOEXEC); });
    if (made < 0) return -1;
    // Another writer may have met it before it was locked, and cleared it away. A file system without locks is none
    // where anybody clears up.
    struct stat found {};
    const bool locked = uninterrupted([&] { return ::flock(made, LOCK_EX); }) == 0;
    if (!locked || ::fstat(made, &found) != 0 || found.st_nlink > 0) return made;
    ::close(made);
  }
  errno = EAGAIN;
  return -1;
}

/// Removes regular files of this user, of our naming, that nobody has locked: those with `prefix`, or all.
void clearLeftovers(const fs::path& folder, const std::string& prefix = {}) {
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    const std::string itsPrefix = prefixIn(it->path().filename().string());
    if (itsPrefix.empty() || (!prefix.empty() && itsPrefix != prefix)) continue;
    // For writing: network file systems lock nothing else.
    const int left = ::open(it->path().c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (left < 0) continue;
    struct stat found {};
    const bool ours = ::fstat(left, &found) == 0 && S_ISREG(found.st_mode) && found.st_uid == ::geteuid();
    if (ours && ::flock(left, LOCK_EX | LOCK_NB) == 0) ::unlink(it->path().c_str());
    ::close(left);
  }
}

/// The file's bytes under another name, which it gets by a link where the file system has links.
Status keepBackup(const fs::path& path) {
  const fs::path backup = path.string() + ".bak";
  std::random_device dice;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::string fresh = prefixOf(backup);
    for (std::size_t i = 0; i < kPlaces.size(); ++i) fresh += static_cast<char>('a' + dice() % 26);
    fresh = (backup.parent_path() / fresh.append(kSuffix)).string();
    if (uninterrupted([&] { return ::link(path.c_str(), fresh.c_str()); }) != 0) {
      if (errno == EEXIST) continue;
      break;
    }
    if (uninterrupted([&] { return ::rename(fresh.c_str(), backup.c_str()); }) == 0) {
      // Two names of one file: rename leaves both.
      ::unlink(fresh.c_str());
      return Done{};
    }
    const int code = errno;
    ::unlink(fresh.c_str());
    return writeError(backup, std::strerror(code));
  }
  const Result<std::string> bytes = readFile(path);
  if (!bytes) return bytes.error();
  struct stat found {};
  if (::stat(path.c_str(), &found) != 0) return writeError(backup, std::strerror(errno));
  // As with a link above: a symbolic link that stands there is replaced, and not written through.
  Result<AtomicFile> copy = AtomicFile::create(backup, found.st_mode & 07777, Links::Replace);
  if (!copy) return copy.error();
  if (Status written = copy->write(*bytes); !written) return written;
  return copy->finish();
}

}  // namespace

Result<AtomicFile> AtomicFile::create(const fs::path& path, std::optional<unsigned> mode, Links links) {
  AtomicFile file;
  file.m_path = path;
  file.m_target = links == Links::Follow ? followed(path) : path;
  if (file.m_target.empty()) return file.failure(ELOOP);
  struct stat old {};
  const bool exists = ::lstat(file.m_target.c_str(), &old) == 0 && !S_ISLNK(old.st_mode);
  if (exists && S_ISDIR(old.st_mode)) return file.failure(EISDIR);
  // Renaming over a device or a pipe would take it away from everybody else.
  if (exists && !S_ISREG(old.st_mode)) return writeError(path, "it is no regular file");
  if (exists && ::access(file.m_target.c_str(), W_OK) != 0) return file.failure(errno);
  file.m_descriptor = makeTemporary(file.m_target, file.m_temporary);
  if (file.m_descriptor < 0) return file.failure(errno);
  // A file system without access rights refuses; nothing is lost by that.
  static_cast<void>(::fchmod(file.m_descriptor, mode.value_or(exists ? old.st_mode & 07777 : newFileMode())));
  return file;
}

AtomicFile::~AtomicFile() {
  abandon();
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : m_path(std::move(other.m_path)),
      m_target(std::move(other.m_target)),
      m_temporary(std::move(other.m_temporary)),
      m_descriptor(std::exchange(other.m_descriptor, -1)) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this != &other) {
    abandon();
    m_path = std::move(other.m_path);
    m_target = std::move(other.m_target);
    m_temporary = std::move(other.m_temporary);
    m_descriptor = std::exchange(other.m_descriptor, -1);
  }
  return *this;
}

Status AtomicFile::write(std::string_view bytes) {
  if (m_descriptor < 0) return failure(EBADF);
  while (!bytes.empty()) {
    const ssize_t n = uninterrupted([&] { return ::write(m_descriptor, bytes.data(), bytes.size()); });
    if (n < 0) {
      const int code = errno;
      abandon();
      return failure(code);
    }
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return Done{};
}

Status AtomicFile::overwrite(std::uint64_t at, std::string_view bytes) {
  if (m_descriptor < 0) return failure(EBADF);
  while (!bytes.empty()) {
    const ssize_t n =
        uninterrupted([&] { return ::pwrite(m_descriptor, bytes.data(), bytes.size(), static_cast<off_t>(at)); });
    if (n < 0) {
      const int code = errno;
      abandon();
      return failure(code);
    }
    at += static_cast<std::uint64_t>(n);
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
  return Done{};
}

Status AtomicFile::finish(Sync sync, Backup backup) {
  if (m_descriptor < 0) return failure(EBADF);
  // Closing may tell of a failure, but it mustn't give up the lock before the file has its name.
  const int lock = ::fcntl(m_descriptor, F_DUPFD_CLOEXEC, 0);
  int code = sync == Sync::Now && uninterrupted([&] { return ::fsync(m_descriptor); }) != 0 ? errno : 0;
  if (::close(std::exchange(m_descriptor, -1)) != 0 && code == 0 && errno != EINTR) code = errno;
  if (code == 0 && backup == Backup::KeepOne && ::access(m_target.c_str(), F_OK) == 0) {
    // Thrown past the rest, the temporary file would stay.
    if (const Status kept = orOutOfMemory("the older file's name", [&] { return keepBackup(m_target); }); !kept)
      logWarning(kept.error().text() + "; the older file is not kept");
  }
  if (code == 0 && uninterrupted([&] { return ::rename(m_temporary.c_str(), m_target.c_str()); }) != 0) code = errno;
  if (code != 0) ::unlink(m_temporary.c_str());
  if (lock >= 0) ::close(lock);
  if (code != 0) return failure(code);
  if (sync == Sync::Later) return Done{};
  // The file has its name and can't get its old bytes back.
  if (const Status synced = syncFolder(m_target.parent_path()); !synced)
    logWarning(synced.error().text() + "; a loss of power may bring the older " + m_path.string() + " back");
  return Done{};
}

void AtomicFile::abandon() {
  if (m_descriptor < 0) return;
  ::unlink(m_temporary.c_str());
  ::close(m_descriptor);
  m_descriptor = -1;
}

Error AtomicFile::failure(int code) const {
  return writeError(m_path, std::strerror(code));
}

Status writeFileUnsynced(const fs::path& path, std::string_view bytes) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  if (Status written = file->write(bytes); !written) return written;
  return file->finish(Sync::Later);
}

Status writeFileAtomically(const fs::path& path, std::string_view bytes, Backup backup, std::optional<unsigned> mode) {
  Result<AtomicFile> file = AtomicFile::create(path, mode);
  if (!file) return file.error();
  if (Status written = file->write(bytes); !written) return written;
  if (Status finished = file->finish(Sync::Now, backup); !finished) return finished;
  const fs::path target = followed(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  clearLeftovers(folder, prefixOf(target));
  if (backup == Backup::KeepOne) clearLeftovers(folder, prefixOf(target.string() + ".bak"));
  return Done{};
}

void clearLeftTemporaries(const fs::path& folder) {
  clearLeftovers(folder);
}

Status syncFolder(const fs::path& folder) {
  const fs::path place = folder.empty() ? fs::path(".") : folder;
  const int opened = uninterrupted([&] { return ::open(place.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); });
  if (opened < 0) return Done{};  // a folder that may be written and not read
  const int code = uninterrupted([&] { return ::fsync(opened); }) != 0 ? errno : 0;
  ::close(opened);
  if (code == 0 || code == EINVAL || code == ENOTSUP || code == EROFS) return Done{};
  return makeError(ErrorKind::Machine, place.string(), {}, std::string("can't be synced: ") + std::strerror(code));
}

}  // namespace windloom
