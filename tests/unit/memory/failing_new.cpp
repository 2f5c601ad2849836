#include "tests/unit/memory/failing_new.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

constexpr long kNever = -1;
std::atomic<long> g_left = kNever, g_wishes = 0, g_alive = 0;
std::atomic<std::size_t> g_least = 0;
std::atomic<bool> g_failed = false;

bool fails(std::size_t bytes) {
  if (bytes < g_least) return false;
  ++g_wishes;
  long left = g_left.load();
  while (left != kNever) {
    // After the one that failed, all are fulfilled again.
    if (g_left.compare_exchange_weak(left, left == 0 ? kNever : left - 1)) {
      if (left > 0) return false;
      g_failed = true;
      return true;
    }
  }
  return false;
}

void* take(std::size_t bytes, std::size_t alignment) noexcept {
  if (fails(bytes)) return nullptr;
  const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
  void* memory = alignment <= alignof(std::max_align_t) ? std::malloc(bytes == 0 ? 1 : bytes)
                                                        : std::aligned_alloc(alignment, whole);
  if (memory != nullptr) ++g_alive;
  return memory;
}

void* takeOrThrow(std::size_t bytes, std::size_t alignment = alignof(std::max_align_t)) {
  if (void* memory = take(bytes, alignment)) return memory;
  throw std::bad_alloc();
}

void give(void* memory) noexcept {
  if (memory == nullptr) return;
  --g_alive;
  std::free(memory);
}

}  // namespace

void* operator new(std::size_t bytes) {
  return takeOrThrow(bytes);
}
void* operator new[](std::size_t bytes) {
  return takeOrThrow(bytes);
}
void* operator new(std::size_t bytes, std::align_val_t to) {
  return takeOrThrow(bytes, std::size_t(to));
}
void* operator new[](std::size_t bytes, std::align_val_t to) {
  return takeOrThrow(bytes, std::size_t(to));
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return take(bytes, alignof(std::max_align_t));
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return take(bytes, alignof(std::max_align_t));
}
void operator delete(void* memory) noexcept {
  give(memory);
}
void operator delete[](void* memory) noexcept {
  give(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  give(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  give(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  give(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
  give(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  give(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
  give(memory);
}
void operator delete(void* memory, const std::nothrow_t&) noexcept {
  give(memory);
}
void operator delete[](void* memory, const std::nothrow_t&) noexcept {
  give(memory);
}

namespace windloom::testing {

void failAfter(long count, std::size_t leastBytes) {
  g_failed = false;
  g_least = leastBytes;
  g_wishes = 0;
  g_left = count;
}

bool stopFailing() {
  g_left = kNever;
  return g_failed;
}

long wishes() {
  return g_wishes;
}

long alive() {
  return g_alive;
}

long failEach(const std::function<void()>& work, const std::function<void()>& after, long stride,
              std::size_t leastBytes) {
  work();  // what is made once for the program, such as tables
  after();
  long runs = 0;
  for (long n = 0;; n += stride) {
    const long before = alive();
    failAfter(n, leastBytes);
    try {
      work();
    } catch (const std::bad_alloc&) {
    }
    const bool failed = stopFailing();
    EXPECT_EQ(alive(), before) << "after wish " << n << " failed";
    after();
    if (!failed || ::testing::Test::HasFailure()) return runs;
    ++runs;
  }
}

}  // namespace windloom::testing
