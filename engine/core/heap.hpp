#pragma once
// The C library's heap as a program sees it that runs for hours and opens large and small projects in turn. Only glibc
// tells and can be told; elsewhere these do nothing.

#include <cstddef>

namespace windloom {

/// Trades a little speed of threads that allocate at once for memory: two arenas for all threads, and blocks of a
/// megabyte and more straight from the system, so that they go back when they are freed. Left alone, glibc keeps an
/// arena for every thread, with holes where buffers were. To be called before threads are started.
void keepHeapTight();

/// Gives back what lies free between blocks that stay. Milliseconds, more where much was freed.
void giveHeapBack();

/// Bytes that the program asked for and did not give back, whatever the allocator keeps beside them; 0 where the C
/// library doesn't tell. Walks through all free blocks.
[[nodiscard]] std::size_t heapBytesInUse();

}  // namespace windloom
