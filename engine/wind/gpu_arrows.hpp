#pragma once
// The arrows of a step on the GPU, binned in tiles. Binning is done again only when arrows moved, came or went.

#include <array>
#include <span>
#include <vector>

#include "engine/gpu/buffer.hpp"
#include "engine/wind/arrow_tiles.hpp"
#include "engine/wind/gpu_cycles.hpp"
#include "engine/wind/gpu_fields.hpp"

namespace windloom {

class GpuArrows {
 public:
  /// Sends what changed since the last call, and says in `fields.block` how to find it. Where the GPU has no memory for
  /// the lists the old arrows stay and the failure goes to the log. Answers whether arrows moved, came or went.
  bool send(GpuFields& fields, std::span<const ArrowForce> arrows);
  void bind() const;

  /// The arrows that send() last compared with, and whether the step had any: what its next answer depends on.
  struct Sent {
    std::vector<ArrowForce> arrows;
    bool blowing = false;
  };
  [[nodiscard]] Sent sent(const GpuFields& fields) const { return {m_sent, fields.block.tileColumns > 0}; }
  /// Back to what was sent then.
  void restore(GpuFields& fields, const Sent& sent) {
    send(fields, sent.arrows);
    if (!sent.blowing) send(fields, {});
  }
  [[nodiscard]] std::size_t memoryBytes() const {
    return m_arrowBuffer.bytes() + m_startBuffer.bytes() + m_indexBuffer.bytes() + m_busyBuffer.bytes();
  }

 private:
  /// One list in as many buffers as steps may be on their way, and two to spare: a list is never written into a buffer
  /// that a step still reads. OpenGL orders such writes, but NVIDIA's driver (580.159) let steps under way see some.
  class Lists {
   public:
    bool write(const char* label, const void* data, std::size_t bytes);
    void bind(unsigned binding) const { m_buffers[m_at].bindStorage(binding); }
    [[nodiscard]] bool empty() const { return m_buffers[m_at].bytes() == 0; }
    [[nodiscard]] std::size_t bytes() const;

   private:
    std::array<gpu::Buffer, GpuCycles::kDelay + 2> m_buffers;
    std::size_t m_at = 0;
  };
  [[nodiscard]] bool sameShapes(std::span<const ArrowForce> arrows) const;
  std::vector<ArrowForce> m_sent;
  glm::vec2 m_corner{0};
  ArrowTiles m_tiles;
  std::vector<std::uint32_t> m_busy;  // tiles that an arrow reaches
  Lists m_arrowBuffer, m_startBuffer, m_indexBuffer, m_busyBuffer;
};

}  // namespace windloom
