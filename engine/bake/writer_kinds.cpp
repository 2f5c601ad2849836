#include "engine/bake/writers.hpp"
#include "engine/bake/zstd_stream.hpp"
#include "engine/runtime/windpack_format.h"

namespace windloom {
namespace {

/// So many bytes for each cell of each frame.
template <int kBytesPerCell>
std::uint64_t bytes(const BakeHeader& header) {
  const glm::ivec2 resolution = header.grid.resolution;
  return static_cast<std::uint64_t>(resolution.x) * static_cast<std::uint64_t>(resolution.y) *
         static_cast<std::uint64_t>(header.written()) * kBytesPerCell;
}

/// Of a wind pack that isn't compressed, to the byte.
template <int kBytesPerCell>
std::uint64_t windpackBytes(const BakeHeader& header) {
  return WINDPACK_HEADER_BYTES + bytes<kBytesPerCell>(header) + WINDPACK_CHECKSUM_BYTES;
}

constexpr WriterKind kKinds[] = {
    {.name = "npy",
     .group = "Data",
     .help = "wind.npy: float32 [frames, height, width, 2], m/s, rows z ascending",
     .exactSize = true,
     .bytes = bytes<8>,
     .open = openNpyWriter},
    {.name = "png",
     .group = "Images",
     .help = "flow.NNNN.png: 8-bit flow maps in the preset's frame",
     .need = SpeedNeed::Range,
     .numbered = true,
     .bytes = bytes<4>,
     .open = openFlowMapWriter},
    {.name = "windpack",
     .group = "Data",
     .help = "wind.windpack: half floats for windloom_runtime",
     .need = SpeedNeed::Fastest,
     .exactSize = true,
     .bytes = windpackBytes<4>,
     .open = openWindpackWriter},
    {.name = "windpack-f32",
     .group = "Data",
     .help = "wind-f32.windpack: the same in floats, twice as large",
     .need = SpeedNeed::Fastest,
     .exactSize = true,
     .bytes = windpackBytes<8>,
     .open = openWindpackFloatWriter},
    {.name = "windpack-zstd",
     .group = "Data",
     .help = "wind-zstd.windpack: half floats packed with zstd, less than half as large, for windloom_runtime_zstd",
     .need = SpeedNeed::Fastest,
     .bytes = windpackBytes<4>,
     .open = openWindpackZstdWriter,
     .missing = kMissingZstd},
};

}  // namespace

std::span<const WriterKind> writerKinds() {
  return kKinds;
}

const WriterKind* writerKindNamed(std::string_view name) {
  for (const WriterKind& kind : kKinds) {
    if (kind.name == name) return &kind;
  }
  return nullptr;
}

}  // namespace windloom
