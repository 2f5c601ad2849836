#include "engine/bake/volume_writers.hpp"
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
    {.name = "fga",
     .group = "Volumes",
     .help = "wind.NNNN.fga: vector fields for Unreal, at most 128 cells a side",
     .numbered = true,
     .bytes = fgaBytes,
     .open = openFgaWriter,
     .warning = fgaWarning},
    {.name = "fga-tiles",
     .group = "Volumes",
     .help = "wind_tX_tY.NNNN.fga: the same in tiles of at most 128 cells a side",
     .numbered = true,
     .bytes = fgaTilesBytes,
     .open = openFgaTilesWriter,
     .warning = fgaTilesWarning},
    {.name = "vf",
     .group = "Volumes",
     .help = "wind.NNNN.vf: volume files for Unity's Visual Effect Graph, version 1",
     .numbered = true,
     .exactSize = true,
     .bytes = vfBytes,
     .open = openVfWriter,
     .warning = vfWarning},
    {.name = "vf2",
     .group = "Volumes",
     .help = "wind-v2.NNNN.vf: version 2, which also says where the volume lies; few importers read it",
     .numbered = true,
     .exactSize = true,
     .bytes = vf2Bytes,
     .open = openVf2Writer,
     .warning = vfWarning},
    {.name = "vdb",
     .group = "Volumes",
     .help = "wind_NNNN.vdb: OpenVDB, half float vectors \"velocity\" in cubic voxels",
     .numbered = true,
     .bytes = vdbBytesOfBake,
     .open = openVdbWriter,
     .warning = vdbWarning,
     .missing = kVdbMissing},
    {.name = "godot-slab",
     .group = "Volumes",
     .help = "slab.NNNN.png: slices of the 3D texture of Godot's GPUParticlesAttractorVectorField3D",
     .need = SpeedNeed::Range,
     .numbered = true,
     .bytes = slabBytes,
     .open = openSlabWriter,
     .warning = slabWarning},
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
