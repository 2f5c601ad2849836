#include "engine/io/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "engine/core/file.hpp"

namespace windloom {

Result<AtomicFile> AtomicFile::create(const std::filesystem::path& path) {
  AtomicFile file;
  file.m_path = path;
  file.m_temporary = path.string() + ".XXXXXX";
  file.m_descriptor = ::mkostemp(file.m_temporary.data(), O_CLOEXEC);
  if (file.m_descriptor < 0) return file.failure(errno);
  if (::fchmod(file.m_descriptor, newFileMode()) != 0) return file.failure(errno);
  return file;
}

AtomicFile::~AtomicFile() {
  abandon();
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : m_path(std::move(other.m_path)),
      m_temporary(std::move(other.m_temporary)),
      m_descriptor(std::exchange(other.m_descriptor, -1)) {}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept {
  if (this != &other) {
    abandon();
    m_path = std::move(other.m_path);
    m_temporary = std::move(other.m_temporary);
    m_descriptor = std::exchange(other.m_descriptor, -1);
  }
  return *this;
}

Status AtomicFile::write(std::string_view bytes) {
  if (m_descriptor < 0) return failure(EBADF);
  while (!bytes.empty()) {
    const ssize_t n = ::write(m_descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
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
    const ssize_t n = ::pwrite(m_descriptor, bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (n < 0 && errno == EINTR) continue;
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

Status AtomicFile::finish(Sync sync) {
  if (m_descriptor < 0) return failure(EBADF);
  int code = sync == Sync::Now && ::fsync(m_descriptor) != 0 ? errno : 0;
  if (::close(m_descriptor) != 0 && code == 0) code = errno;
  m_descriptor = -1;
  if (code == 0 && ::rename(m_temporary.c_str(), m_path.c_str()) != 0) code = errno;
  if (code == 0) return Done{};
  ::unlink(m_temporary.c_str());
  return failure(code);
}

void AtomicFile::abandon() {
  if (m_descriptor < 0) return;
  ::close(m_descriptor);
  ::unlink(m_temporary.c_str());
  m_descriptor = -1;
}

Error AtomicFile::failure(int code) const {
  return makeError(ErrorKind::Machine, m_path.string(), {}, std::string("can't write: ") + std::strerror(code));
}

Status writeFileUnsynced(const std::filesystem::path& path, std::string_view bytes) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  if (Status written = file->write(bytes); !written) return written;
  return file->finish(Sync::Later);
}

}  // namespace windloom
