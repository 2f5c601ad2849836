#include "engine/core/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace windloom {
namespace fs = std::filesystem;
namespace {

Error ioError(const fs::path& path, const char* doing, int code) {
  return makeError(ErrorKind::Machine, path.string(), {}, std::string("can't ") + doing + ": " + std::strerror(code));
}

/// Closes on scope exit.
struct Descriptor {
  int fd = -1;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

}  // namespace

Result<std::string> readFile(const fs::path& path, std::uint64_t limitBytes) {
  const Descriptor d{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (d.fd < 0) {
    const ErrorKind kind = errno == ENOENT || errno == ENOTDIR ? ErrorKind::BadInput : ErrorKind::Machine;
    return makeError(kind, path.string(), {}, std::string("can't open: ") + std::strerror(errno));
  }
  struct stat info {};
  if (::fstat(d.fd, &info) != 0) return ioError(path, "read", errno);
  if (S_ISDIR(info.st_mode)) return makeError(ErrorKind::BadInput, path.string(), {}, "is a folder, expected a file");
  std::string bytes;
  char chunk[1 << 16];
  for (;;) {
    const ssize_t n = ::read(d.fd, chunk, sizeof chunk);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return ioError(path, "read", errno);
    if (n == 0) return bytes;
    bytes.append(chunk, static_cast<std::size_t>(n));
    if (bytes.size() > limitBytes) {
      return makeError(ErrorKind::BadInput, path.string(), {},
                       "is larger than the limit of " + std::to_string(limitBytes) + " bytes");
    }
  }
}

unsigned newFileMode() {
  static const mode_t mode = [] {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
  }();
  return mode;
}

Status makeFolder(const fs::path& path) {
  std::error_code ec;
  fs::create_directories(path, ec);
  if (ec) return makeError(ErrorKind::Machine, path.string(), {}, "can't make this folder: " + ec.message());
  return Done{};
}

Result<fs::path> findDataFolder(std::string_view name) {
  std::vector<fs::path> tried;
  if (const char* given = std::getenv("WINDLOOM_DATA")) tried.emplace_back(fs::path(given) / name);
  // No path of the machine that built the program: a build folder is laid out as a prefix, with links to the sources.
  std::error_code ec;
  const fs::path program = fs::read_symlink("/proc/self/exe", ec);
  if (!ec) tried.emplace_back(program.parent_path().parent_path() / "share" / "windloom" / name);
  std::string list;
  for (const fs::path& folder : tried) {
    if (fs::is_directory(folder, ec)) return folder;
    list += (list.empty() ? "" : ", ") + folder.string();
  }
  return makeError(ErrorKind::Machine, "can't find the folder '" + std::string(name) + "' (tried " + list + ")");
}

}  // namespace windloom
