#include "engine/core/memory_reserve.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace windloom {
namespace {

std::atomic<void*> g_reserve = nullptr;

void giveBack() {
  void* reserve = g_reserve.exchange(nullptr);
  if (reserve == nullptr) throw std::bad_alloc();
  std::free(reserve);
}

}  // namespace

void keepMemoryReserve(std::size_t bytes) {
  if (g_reserve == nullptr) {
    void* kept = std::malloc(bytes);
    void* none = nullptr;
    if (!g_reserve.compare_exchange_strong(none, kept)) std::free(kept);
  }
  std::set_new_handler(giveBack);
}

}  // namespace windloom
