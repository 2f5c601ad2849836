#pragma once
// Contract checks: a broken promise between parts of the program ends it with a message and the
// place, in release builds too. Never used for bad input: that is a Result.

namespace windloom {
[[noreturn]] void contractBroken(const char* condition, const char* message, const char* file, int line);
}

#define WL_REQUIRE(condition, message) \
  (static_cast<bool>(condition) ? static_cast<void>(0) : ::windloom::contractBroken(#condition, message, __FILE__, __LINE__))
