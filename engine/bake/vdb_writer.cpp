// OpenVDB volumes, one file a frame, for renderers, simulations and Unreal's sparse volume textures; in the preset's
// frame and unit. Readers want cubic voxels, so the field is brought to such.

#include "engine/bake/voxel_field.hpp"
#include "engine/bake/writers.hpp"
#include "engine/core/atomic_file.hpp"
#ifdef WINDLOOM_OPENVDB
#include "engine/bake/vdb_bytes.hpp"
#endif

namespace windloom {
namespace {

std::int64_t voxelsOf(const BakeHeader& header) {
  const glm::ivec3 size = VoxelField::sizeFor(header);
  return std::int64_t{size.x} * size.y * size.z;
}

#ifdef WINDLOOM_OPENVDB

class VdbWriter final : public FrameWriter {
 public:
  VdbWriter(const BakeHeader& header, std::filesystem::path folder)
      : m_track(header.track), m_folder(std::move(folder)), m_field(header) {}

  Status add(int frame, std::span<const glm::vec2> cells) override {
    m_field.block(cells, m_block);
    const Volume& volume = m_field.volume();
    VdbBlock block;
    block.size = volume.size();
    block.side = m_field.side();
    block.low = volume.box().min;
    block.vectors = m_block;
    Result<std::string> bytes = vdbBytes(block);
    if (!bytes) return bytes.error();
    nlohmann::ordered_json details = volume.details(frame);
    details["grids"] = {block.name};
    details["voxel"] = plainTriple(glm::vec3(block.side))[0];
    m_files.push_back({fileName(frame), "volume", "half", std::move(details)});
    return writeFileUnsynced(m_folder / m_files.back().path, *bytes);
  }

  Result<std::vector<BakedFile>> finish() override { return std::move(m_files); }

 private:
  /// "wind_0007.vdb": programs find sequences of volumes by a number at the end of the name.
  [[nodiscard]] std::string fileName(int frame) const {
    std::string name = frameFile(m_track, "wind", frame, "vdb");
    name[stemOf(m_track, "wind").size()] = '_';
    return name;
  }

  Track m_track;
  std::filesystem::path m_folder;
  VoxelField m_field;
  std::vector<glm::vec3> m_block;
  std::vector<BakedFile> m_files;
};

#endif

}  // namespace

OpenedWriter openVdbWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  if (std::string refusal = vdbRefusal(header); !refusal.empty()) return makeError(ErrorKind::BadInput, refusal);
#ifdef WINDLOOM_OPENVDB
  return std::unique_ptr<FrameWriter>(std::make_unique<VdbWriter>(header, folder));
#else
  static_cast<void>(folder);
  return makeError(ErrorKind::Machine, std::string(kVdbMissing));
#endif
}

/// At most: half floats before compression.
std::uint64_t vdbBytesOfBake(const BakeHeader& header) {
  return static_cast<std::uint64_t>(voxelsOf(header)) * 6 * static_cast<std::uint64_t>(header.written());
}

std::string vdbRefusal(const BakeHeader& header) {
  if (voxelsOf(header) <= kMostVoxels) return {};
  const glm::ivec3 size = VoxelField::sizeFor(header);
  return "with voxels as wide as a cell is, in all directions, this volume has " + std::to_string(size.x) + " x " +
         std::to_string(size.y) + " x " + std::to_string(size.z) + " of them, the most is " +
         std::to_string(kMostVoxels >> 20) + " million; lower the resolution or the height of the volume";
}

std::string vdbWarning(const BakeHeader& header) {
  const glm::ivec3 size = VoxelField::sizeFor(header);
  const glm::ivec2 cells = header.grid.resolution;
  if (size.x == cells.x && size.z == cells.y) return {};
  return "cells that aren't square are brought to " + std::to_string(size.x) + " x " + std::to_string(size.z) +
         " cubic voxels";
}

}  // namespace windloom
