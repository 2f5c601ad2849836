#pragma once
// Where memory ends: rooms let std::bad_alloc pass, since nearly every line may throw it. Threads, and whoever would
// lose a user's work by it, turn it into an error here.

#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "engine/core/result.hpp"

namespace windloom {

/// "not enough memory for WHAT".
inline Error outOfMemory(std::string_view what) {
  return makeError(ErrorKind::Machine, std::string("not enough memory for ").append(what));
}

/// What `work` gives, a Result or Status; outOfMemory(what) where memory ended in it, all that it had taken freed.
/// Throws std::bad_alloc only where not even that message can be had.
template <class Work>
std::invoke_result_t<Work> orOutOfMemory(std::string_view what, Work&& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return outOfMemory(what);
  } catch (const std::length_error&) {  // longer than any memory: what a size computed from a file may ask for
    return outOfMemory(what);
  }
}

}  // namespace windloom
