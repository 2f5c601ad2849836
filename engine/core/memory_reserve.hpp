#pragma once
// A little memory kept aside for when there is no more: to give back what was half made, to save, to say so.

#include <cstddef>

namespace windloom {

/// Keeps `bytes` aside for the whole program. Where a wish for memory can't be fulfilled, they are given back and the
/// wish is tried once more; only then std::bad_alloc is thrown, and what unwinds finds memory. Called again later (a
/// frame that ended well, say) it keeps them aside anew. For main functions: it sets the program's new handler.
void keepMemoryReserve(std::size_t bytes = 8u << 20);

}  // namespace windloom
