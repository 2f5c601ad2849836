#pragma once
// The log: one line a message, to standard error unless a sink takes it (the editor's log panel). Whatever a message
// quotes, it is written as printableLines gives it (engine/core/text.hpp).
// Safe to call from any thread.

#include <functional>
#include <string_view>

namespace windloom {

enum class LogLevel { Info, Warning, Error };

void logInfo(std::string_view message);
void logWarning(std::string_view message);
void logError(std::string_view message);

/// Also passes every later message to `sink`; an empty sink removes it. The sink must not log.
void setLogSink(std::function<void(LogLevel, std::string_view)> sink);

/// Messages below `level` are dropped. Default: Info.
void setLogLevel(LogLevel level);

}  // namespace windloom
