#include "engine/core/log.hpp"

#include <cstdio>
#include <mutex>
#include <new>
#include <utility>

#include "engine/core/text.hpp"

namespace windloom {
namespace {

struct Log {
  std::mutex mutex;
  std::function<void(LogLevel, std::string_view)> sink;
  LogLevel level = LogLevel::Info;
};

Log& log() {
  static Log instance;
  return instance;
}

void write(LogLevel level, std::string_view message) {
  static constexpr const char* kPrefix[] = {"", "warning: ", "error: "};
  Log& state = log();
  const std::lock_guard lock(state.mutex);
  if (level < state.level) return;
  std::fputs(kPrefix[static_cast<int>(level)], stderr);
  std::string shown;
  try {
    shown = printableLines(message);
  } catch (const std::bad_alloc&) {
    // That memory ends is told from where nothing may be thrown.
    for (const char c : message) std::fputc(static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c, stderr);
  }
  std::fprintf(stderr, "%s\n", shown.c_str());
  if (state.sink && !shown.empty()) state.sink(level, shown);
}

}  // namespace

void logInfo(std::string_view message) {
  write(LogLevel::Info, message);
}
void logWarning(std::string_view message) {
  write(LogLevel::Warning, message);
}
void logError(std::string_view message) {
  write(LogLevel::Error, message);
}

void setLogSink(std::function<void(LogLevel, std::string_view)> sink) {
  const std::lock_guard lock(log().mutex);
  log().sink = std::move(sink);
}

void setLogLevel(LogLevel level) {
  const std::lock_guard lock(log().mutex);
  log().level = level;
}

}  // namespace windloom
