#pragma once
// Buffers for lists whose length changes from frame to frame.

#include <string_view>

#include "engine/gpu/buffer.hpp"

namespace windloom {

/// Makes sure that `buffer` holds `bytes` > 0; a new one, empty, has half as much to spare, so that growing lists
/// rarely make another. False where the machine has no room, which is logged; the buffer is then as it was.
bool makeRoom(gpu::Buffer& buffer, std::string_view label, std::size_t bytes,
              gpu::BufferUse use = gpu::BufferUse::Dynamic);

}  // namespace windloom
