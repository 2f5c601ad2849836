#pragma once
// Reading results of the GPU without waiting: copies go to a ring of buffers, each with a fence, and are
// looked at when their fence has passed.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/gpu/buffer.hpp"
#include "engine/gpu/texture.hpp"

namespace windloom::gpu {

class ReadbackRing {
 public:
  /// Results of up to `bytes` bytes, `slots` of them in flight. Fails with Machine.
  static Result<ReadbackRing> create(std::string_view label, std::size_t bytes, int slots = 4);
  ReadbackRing() = default;
  ReadbackRing(ReadbackRing&&) noexcept;
  ReadbackRing& operator=(ReadbackRing&&) noexcept;
  ~ReadbackRing();

  /// Copies a part of a buffer; `tag` comes back with it. Where every slot is in flight nothing is copied
  /// and the answer is false. Issues the barrier for shader writes to the buffer itself.
  bool request(const Buffer& source, std::size_t offset, std::size_t bytes, long tag);
  /// The same for level 0 of a 2D texture in tightly packed rows.
  bool request(const Texture& source, GLenum pixelFormat, GLenum pixelType, long tag) {
    return request(source.name(), pixelFormat, pixelType, tag);
  }
  bool request(GLuint texture, GLenum pixelFormat, GLenum pixelType, long tag);

  struct Arrival {
    long tag = 0;
    std::span<const std::byte> bytes;  ///< valid until the next request()
  };
  /// The newest result that has arrived since the last call; never waits.
  std::optional<Arrival> poll();
  /// Waits for all requests, then as poll().
  std::optional<Arrival> finish();

  /// The GPU was reset, or the driver can't wait: what was asked for and not taken yet will never come.
  [[nodiscard]] bool failed() const { return m_failed; }

  enum class Wait { No, Yes };
  /// The oldest result not taken yet: for those who need every one, in order.
  std::optional<Arrival> takeOldest(Wait wait);

 private:
  struct Slot {
    Handle<BufferKind> buffer;
    const std::byte* mapped = nullptr;
    GLsync fence = nullptr;
    std::size_t bytes = 0;
    long tag = 0;
  };
  Slot* freeSlot();
  std::optional<Arrival> collect(Wait wait);
  void dropFences();

  std::vector<Slot> m_slots;
  std::size_t m_bytes = 0, m_next = 0;
  bool m_failed = false;
};

}  // namespace windloom::gpu
