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
    {.name = "exr",
     .group = "Images",
     .help = "wind.NNNN.exr: half floats, vector and length; the master recording",
     .numbered = true,
     .bytes = exrBytes,
     .open = openExrWriter},
    {.name = "png16",
     .group = "Images",
     .help = "flow16.NNNN.png: 16-bit flow maps",
     .need = SpeedNeed::Range,
     .numbered = true,
     .bytes = bytes<8>,
     .open = openPng16Writer},
    {.name = "atlas",
     .group = "Images",
     .help = "flow-atlas.png: all frames as tiles of one 8-bit flow map",
     .need = SpeedNeed::Range,
     .bytes = bytes<4>,
     .open = openAtlasWriter,
     .refusal = atlasRefusal},
    {.name = "dds",
     .group = "Textures",
     .help = "wind.dds: texture array of RG half floats",
     .exactSize = true,
     .bytes = ddsBytes,
     .open = openDdsWriter,
     .refusal = ddsArrayRefusal},
    {.name = "dds-rgba",
     .group = "Textures",
     .help = "wind-rgba.dds: texture array of RGBA half floats, B the length",
     .exactSize = true,
     .bytes = ddsRgbaBytes,
     .open = openDdsRgbaWriter,
     .refusal = ddsArrayRefusal},
    {.name = "dds-bc5",
     .group = "Textures",
     .help = "flow-bc5.dds: compressed texture array, a byte a cell",
     .need = SpeedNeed::Range,
     .exactSize = true,
     .bytes = ddsBc5Bytes,
     .open = openDdsBc5Writer,
     .refusal = ddsArrayRefusal},
    {.name = "dds-volume",
     .group = "Textures",
     .help = "wind-volume.dds: 3D texture of RG half floats whose slices are the frames",
     .exactSize = true,
     .bytes = ddsBytes,
     .open = openDdsVolumeWriter,
     .refusal = ddsVolumeRefusal},
    {.name = "ktx2",
     .group = "Textures",
     .help = "wind.ktx2: texture array of RG half floats",
     .exactSize = true,
     .bytes = ktx2Bytes,
     .open = openKtx2Writer,
     .warning = ktx2Warning},
    {.name = "ktx2-rgba",
     .group = "Textures",
     .help = "wind-rgba.ktx2: texture array of RGBA half floats, B the length",
     .exactSize = true,
     .bytes = ktx2RgbaBytes,
     .open = openKtx2RgbaWriter,
     .warning = ktx2Warning},
    {.name = "ktx2-bc5",
     .group = "Textures",
     .help = "flow-bc5.ktx2: compressed texture array, a byte a cell",
     .need = SpeedNeed::Range,
     .exactSize = true,
     .bytes = ktx2Bc5Bytes,
     .open = openKtx2Bc5Writer,
     .warning = ktx2Warning},
    {.name = "ktx2-zstd",
     .group = "Textures",
     .help = "wind-zstd.ktx2: as ktx2, packed with zstd",
     .bytes = ktx2Bytes,
     .open = openKtx2ZstdWriter,
     .warning = ktx2Warning},
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
