#include "engine/bake/frame_spool.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

namespace windloom {
namespace {

Error spoolError(const std::filesystem::path& folder, const char* doing, int code) {
  return makeError(ErrorKind::Machine, folder.string(), {},
                   std::string("can't ") + doing + " the recording's temporary file: " + std::strerror(code));
}

}  // namespace

FrameSpool::FrameSpool(std::size_t cells, std::filesystem::path folder, std::uint64_t memoryBytes)
    : m_cells(cells),
      m_folder(std::move(folder)),
      m_framesInMemory(static_cast<std::size_t>(memoryBytes / (cells * sizeof(glm::vec2)))) {}

FrameSpool::~FrameSpool() {
  if (m_file >= 0) ::close(m_file);
}

Status FrameSpool::openFile() {
  std::string name = (m_folder / "recording.XXXXXX").string();
  m_file = ::mkostemp(name.data(), O_CLOEXEC);
  if (m_file < 0) return spoolError(m_folder, "make", errno);
  ::unlink(name.c_str());
  return Done{};
}

Status FrameSpool::add(std::span<const glm::vec2> frame) {
  WL_REQUIRE(frame.size() == m_cells, "all frames of a recording have the same size");
  if (m_memory.size() < m_framesInMemory) {
    m_memory.emplace_back(frame.begin(), frame.end());
    ++m_frames;
    return Done{};
  }
  if (m_file < 0) {
    if (Status opened = openFile(); !opened) return opened;
  }
  const char* from = reinterpret_cast<const char*>(frame.data());
  for (std::size_t left = frame.size_bytes(); left > 0;) {
    const ssize_t n = ::write(m_file, from, left);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return spoolError(m_folder, "write", errno);
    from += n;
    left -= static_cast<std::size_t>(n);
  }
  ++m_frames;
  return Done{};
}

Status FrameSpool::read(int index, std::vector<glm::vec2>& out) const {
  WL_REQUIRE(index >= 0 && index < m_frames, "only recorded frames can be read");
  const auto frame = static_cast<std::size_t>(index);
  if (frame < m_memory.size()) {
    out = m_memory[frame];
    return Done{};
  }
  out.resize(m_cells);
  const std::size_t bytes = m_cells * sizeof(glm::vec2);
  auto offset = static_cast<off_t>((frame - m_memory.size()) * bytes);
  char* to = reinterpret_cast<char*>(out.data());
  for (std::size_t left = bytes; left > 0;) {
    const ssize_t n = ::pread(m_file, to, left, offset);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return spoolError(m_folder, "read", n < 0 ? errno : EIO);
    to += n;
    offset += n;
    left -= static_cast<std::size_t>(n);
  }
  return Done{};
}

}  // namespace windloom
