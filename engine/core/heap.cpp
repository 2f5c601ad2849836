#include "engine/core/heap.hpp"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace windloom {

void keepHeapTight() {
#if defined(__GLIBC__)
  constexpr int kArenas = 2, kMapped = 1 << 20, kKeptAtTop = 4 << 20;
  mallopt(M_ARENA_MAX, kArenas);
  // Setting them also stops glibc from raising them to what was last freed, 32 MiB and 64 MiB in the end.
  mallopt(M_MMAP_THRESHOLD, kMapped);
  mallopt(M_TRIM_THRESHOLD, kKeptAtTop);
#endif
}

void giveHeapBack() {
#if defined(__GLIBC__)
  malloc_trim(0);
#endif
}

std::size_t heapBytesInUse() {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
#else
  return 0;
#endif
}

}  // namespace windloom
