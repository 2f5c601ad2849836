#include "engine/render/buffer_room.hpp"

#include "engine/core/log.hpp"

namespace windloom {

bool makeRoom(gpu::Buffer& buffer, std::string_view label, std::size_t bytes, gpu::BufferUse use) {
  if (buffer.bytes() >= bytes) return true;
  Result<gpu::Buffer> made = gpu::Buffer::create(label, bytes + bytes / 2, use);
  if (!made) {
    logError(made.error().text());
    return false;
  }
  buffer = std::move(*made);
  return true;
}

}  // namespace windloom
