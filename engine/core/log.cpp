#include "engine/core/log.hpp"

#include <cstdio>
#include <mutex>
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
  const std::string shown = printableLines(message);
  std::fprintf(stderr, "%s%s\n", kPrefix[static_cast<int>(level)], shown.c_str());
  if (state.sink) state.sink(level, shown);
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
