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

Status readFileInPieces(const fs::path& path, const std::function<void(std::string_view)>& use,
                        std::uint64_t limitBytes) {
  const auto bad = [&](std::string what) { return makeError(ErrorKind::BadInput, path.string(), {}, std::move(what)); };
  const auto tooLarge = [&] { return bad("is larger than the limit of " + std::to_string(limitBytes) + " bytes"); };
  // Not blocking: opening a pipe would wait for who never writes to it, and reading a device may never end.
  const Descriptor d{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
  if (d.fd < 0 && errno == ENXIO) return bad("is a socket, expected a file");
  if (d.fd < 0) {
    const ErrorKind kind = errno == ENOENT || errno == ENOTDIR ? ErrorKind::BadInput : ErrorKind::Machine;
    return makeError(kind, path.string(), {}, std::string("can't open: ") + std::strerror(errno));
  }
  struct stat info {};
  if (::fstat(d.fd, &info) != 0) return ioError(path, "read", errno);
  if (S_ISDIR(info.st_mode)) return bad("is a folder, expected a file");
  if (!S_ISREG(info.st_mode)) return bad("is a pipe or a device, expected a file");
  if (static_cast<std::uint64_t>(info.st_size) > limitBytes) return tooLarge();
  char chunk[1 << 16];
  for (std::uint64_t total = 0;;) {
    const ssize_t n = ::read(d.fd, chunk, sizeof chunk);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return ioError(path, "read", errno);
    if (n == 0) return Done{};
    // It may have grown, and files of /proc say that they are empty.
    total += static_cast<std::uint64_t>(n);
    if (total > limitBytes) return tooLarge();
    use({chunk, static_cast<std::size_t>(n)});
  }
}

Result<std::string> readFile(const fs::path& path, std::uint64_t limitBytes) {
  std::string bytes;
  std::error_code unknown;
  if (const std::uint64_t size = fs::file_size(path, unknown); !unknown && size <= limitBytes) bytes.reserve(size);
  if (Status read = readFileInPieces(
          path, [&](std::string_view piece) { bytes += piece; }, limitBytes);
      !read)
    return read.error();
  return bytes;
}

unsigned newFileMode() {
  static const mode_t mode = [] {
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666 & ~mask;
  }();
  return mode;
}

namespace {

/// The folder and its parents; 0 or the number of the error.
int makeFolders(const fs::path& path, unsigned mode) {
  std::error_code ec;
  if (fs::is_directory(path, ec)) return 0;
  if (path.has_parent_path() && path != path.parent_path()) {
    if (const int code = makeFolders(path.parent_path(), mode); code != 0) return code;
  }
  if (::mkdir(path.c_str(), mode) == 0) return 0;
  if (errno != EEXIST) return errno;
  return fs::is_directory(path, ec) ? 0 : ENOTDIR;
}

}  // namespace

Status makeFolder(const fs::path& path, unsigned mode) {
  const int code = makeFolders(path, mode);
  return code == 0 ? Status(Done{}) : ioError(path, "make this folder", code);
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
