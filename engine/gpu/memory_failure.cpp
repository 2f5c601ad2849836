#include "engine/gpu/memory_failure.hpp"

#include <mutex>
#include <utility>

namespace windloom::gpu {
namespace {

struct Counted {
  std::mutex mutex;
  MemoryFailures failures;
};

Counted& counted() {
  static Counted instance;
  return instance;
}

}  // namespace

MemoryFailures memoryFailures() {
  const std::lock_guard lock(counted().mutex);
  return counted().failures;
}

Error memoryFailure(std::string text) {
  {
    const std::lock_guard lock(counted().mutex);
    ++counted().failures.count;
    counted().failures.last = text;
  }
  return makeError(ErrorKind::Machine, std::move(text));
}

}  // namespace windloom::gpu
