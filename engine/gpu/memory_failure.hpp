#pragma once
// What OpenGL had no memory for. Whoever asked for it gets an Error; who draws goes on without what could not be made
// and tells it in the log. Here the whole program can see that it happened: a picture is then not what it should be,
// and work that isn't saved had better be.

#include <string>

#include "engine/core/result.hpp"

namespace windloom::gpu {

struct MemoryFailures {
  long count = 0;    ///< so far, in all threads of this process
  std::string last;  ///< in words; empty: there was none
};
MemoryFailures memoryFailures();

/// Counts it; gives the error with which to refuse.
Error memoryFailure(std::string text);

}  // namespace windloom::gpu
