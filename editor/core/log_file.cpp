#include "editor/core/log_file.hpp"

#include <execinfo.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <string>
#include <system_error>

#include "engine/core/file.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

namespace fs = std::filesystem;

/// For the signal handler, which can't be given anything.
volatile sig_atomic_t crashDescriptor = -1;

std::string stamp() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  char text[32] = "";
  if (::localtime_r(&now, &parts)) std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S ", &parts);
  return text + std::to_string(::getpid()) + " ";
}

/// Only calls that are allowed in a signal handler (backtrace is, once its library was loaded by an earlier call).
void onCrash(int signal) {
  char line[] = "crashed by signal 00\n";
  line[sizeof line - 4] = static_cast<char>('0' + signal / 10);
  line[sizeof line - 3] = static_cast<char>('0' + signal % 10);
  if (::write(crashDescriptor, line, sizeof line - 1) > 0) {
    std::array<void*, 64> calls{};
    ::backtrace_symbols_fd(calls.data(), ::backtrace(calls.data(), static_cast<int>(calls.size())), crashDescriptor);
  }
  ::raise(signal);  // SA_RESETHAND: ends the program as it would have
}

}  // namespace

LogFile::LogFile(const fs::path& folder) : m_path(folder / "log.txt") {
  if (!folder.empty() && makeFolder(folder, kOwnersFolder)) open();
}

LogFile::~LogFile() {
  if (m_descriptor < 0) return;
  if (crashDescriptor == m_descriptor) crashDescriptor = -1;
  ::close(m_descriptor);
}

void LogFile::open() {
  struct stat found {};
  if (::stat(m_path.c_str(), &found) == 0 && static_cast<std::uint64_t>(found.st_size) >= kMostLogBytes) turnOver();
  m_descriptor = ::open(m_path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_NONBLOCK | O_NOCTTY | O_CLOEXEC, 0600);
  m_bytes = m_descriptor >= 0 && ::fstat(m_descriptor, &found) == 0 ? static_cast<std::uint64_t>(found.st_size) : 0;
}

void LogFile::turnOver() {
  std::error_code ignored;
  fs::rename(m_path, m_path.parent_path() / "log.old.txt", ignored);
  if (ignored) fs::remove(m_path, ignored);
}

void LogFile::add(LogLevel level, std::string_view text) {
  if (m_descriptor < 0) return;
  if (m_bytes >= kMostLogBytes) {
    const bool caught = crashDescriptor == m_descriptor;
    ::close(m_descriptor);
    open();
    if (caught) crashDescriptor = m_descriptor;
    if (m_descriptor < 0) return;
  }
  static constexpr std::string_view kLevels[] = {"", "warning: ", "error: "};
  std::string line = stamp();
  line.append(kLevels[static_cast<int>(level)]).append(printableLines(text)).append("\n");
  // In one call, so that lines of several editors don't mix. A rest that isn't written is lost.
  const ssize_t n = ::write(m_descriptor, line.data(), line.size());
  if (n > 0) m_bytes += static_cast<std::uint64_t>(n);
}

void LogFile::catchCrashes() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return;  // sanitizers tell more, and where they are told to
#else
  if (m_descriptor < 0) return;
  std::array<void*, 1> loaded{};
  ::backtrace(loaded.data(), 1);
  crashDescriptor = m_descriptor;
  struct sigaction action {};
  action.sa_handler = onCrash;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigaction(signal, &action, nullptr);
#endif
}

}  // namespace windloom::editor
