#include "engine/bake/writers.hpp"

namespace windloom {
namespace {

/// So many bytes for each cell of each frame.
template <int kBytesPerCell>
std::uint64_t bytes(const BakeHeader& header) {
  const glm::ivec2 resolution = header.grid.resolution;
  return static_cast<std::uint64_t>(resolution.x) * static_cast<std::uint64_t>(resolution.y) *
         static_cast<std::uint64_t>(header.written()) * kBytesPerCell;
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
     .bytes = bytes<4>,
     .open = openWindpackWriter},
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
