#include "engine/bake/frame_writer.hpp"

namespace windloom {
namespace {

template <int kBytesPerCell>
std::uint64_t bytes(glm::ivec2 resolution) {
  return static_cast<std::uint64_t>(resolution.x) * static_cast<std::uint64_t>(resolution.y) * kBytesPerCell;
}

constexpr WriterKind kKinds[] = {
    {"npy", "wind.npy: float32 [frames, height, width, 2], m/s, rows z ascending", SpeedNeed::None, bytes<8>,
     openNpyWriter},
    {"png", "flow.NNNN.png: 8-bit flow maps in the preset's frame", SpeedNeed::Range, bytes<4>, openFlowMapWriter},
    {"windpack", "wind.windpack: half floats for windloom_runtime", SpeedNeed::Fastest, bytes<4>, openWindpackWriter},
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
