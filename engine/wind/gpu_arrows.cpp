#include "engine/wind/gpu_arrows.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "engine/core/log.hpp"
#include "shaders/shared/wind_block.h"

namespace windloom {

/// Makes room, with some to spare, and writes.
bool GpuArrows::Lists::write(const char* label, const void* data, std::size_t bytes) {
  m_at = (m_at + 1) % m_buffers.size();
  gpu::Buffer& buffer = m_buffers[m_at];
  const std::size_t wanted = std::max<std::size_t>(bytes, 256);
  if (buffer.bytes() < wanted) {
    Result<gpu::Buffer> made = gpu::Buffer::create(label, std::bit_ceil(wanted), gpu::BufferUse::Dynamic);
    if (!made) {
      logError(made.error().text());
      return false;
    }
    buffer = std::move(*made);
  }
  buffer.write(data, bytes);
  return true;
}

std::size_t GpuArrows::Lists::bytes() const {
  std::size_t sum = 0;
  for (const gpu::Buffer& buffer : m_buffers) sum += buffer.bytes();
  return sum;
}

namespace {

template <class T, class List>
bool write(List& list, const char* label, const std::vector<T>& values) {
  return list.write(label, values.data(), values.size() * sizeof(T));
}

}  // namespace

bool GpuArrows::sameShapes(std::span<const ArrowForce> arrows) const {
  return std::equal(arrows.begin(), arrows.end(), m_sent.begin(), m_sent.end(),
                    [](const ArrowForce& a, const ArrowForce& b) {
                      return a.from == b.from && a.to == b.to && a.radius == b.radius;
                    });
}

bool GpuArrows::send(GpuFields& fields, std::span<const ArrowForce> arrows) {
  const bool hadSome = fields.block.tileColumns > 0;
  if (arrows.empty()) {
    fields.block.tileColumns = fields.block.busyTiles = 0;
    return hadSome;
  }
  const glm::vec2 corner = fields.grid.mapping.minCorner;
  const bool rebin = m_startBuffer.empty() || corner != m_corner || !sameShapes(arrows);
  const bool changed = rebin || std::memcmp(arrows.data(), m_sent.data(), arrows.size_bytes()) != 0;
  if (changed) m_sent.assign(arrows.begin(), arrows.end());
  bool sent = !changed || write(m_arrowBuffer, "wind arrows", m_sent);
  if (rebin && sent) {
    binArrows(fields.grid, arrows, m_tiles);
    m_corner = corner;
    m_busy.clear();
    for (std::size_t t = 0; t + 1 < m_tiles.start.size(); ++t) {
      if (m_tiles.start[t] < m_tiles.start[t + 1]) m_busy.push_back(static_cast<std::uint32_t>(t));
    }
    sent = write(m_startBuffer, "wind tile starts", m_tiles.start) &&
           write(m_indexBuffer, "wind tile arrows", m_tiles.indices) && write(m_busyBuffer, "wind busy tiles", m_busy);
  }
  fields.block.tileColumns = sent ? m_tiles.columns : 0;
  fields.block.tileSide = m_tiles.cellsPerSide;
  fields.block.busyTiles = sent ? static_cast<int>(m_busy.size()) : 0;
  return rebin || !hadSome;
}

void GpuArrows::bind() const {
  if (m_startBuffer.empty()) return;
  m_arrowBuffer.bind(WIND_SSBO_ARROWS);
  m_startBuffer.bind(WIND_SSBO_TILE_START);
  m_indexBuffer.bind(WIND_SSBO_TILE_ARROWS);
  m_busyBuffer.bind(WIND_SSBO_BUSY_TILES);
}

}  // namespace windloom
