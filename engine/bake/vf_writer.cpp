// .vf, the volume files that Unity's Visual Effect Graph imports as 3D textures: version 1 ("VF_V": ten bytes, then
// vectors of floats) is the one importers read, version 2 ("VF2X") also has the place of the volume. Always in Unity's
// frame: left-handed, +Y up, metres.

#include <bit>
#include <cstring>

#include "engine/bake/volume.hpp"
#include "engine/bake/writers.hpp"
#include "engine/core/atomic_file.hpp"

namespace windloom {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers go to the file as they lie in memory");
static_assert(sizeof(glm::vec3) == 12);

constexpr int kMostPerSide = 2048;  // Unity's 3D textures
constexpr std::uint64_t kHeaderBytes = 10, kHeader2Bytes = 77;

/// Which of our axes Unity's scene has negated depends on the importer of its models, so on the preset.
Preset unityPreset(const BakeHeader& header) {
  return header.preset == Preset::UnityNegZ ? Preset::UnityNegZ : Preset::Unity;
}

template <class Number>
void put(std::string& bytes, Number value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void putSize(std::string& bytes, glm::ivec3 size) {
  for (int axis = 0; axis < 3; ++axis) put(bytes, static_cast<std::uint16_t>(size[axis]));
}

/// The header of version 2; the matrix brings a box of side 1 around 0 to the volume's place.
std::string header2(const Volume& volume) {
  std::string bytes = "VF2X";
  bytes += '\0';  // minor version
  bytes += '\2';  // type: three floats
  bytes += '\2';  // usage: vectors
  putSize(bytes, volume.size());
  const glm::vec3 side = volume.box().max - volume.box().min, centre = 0.5f * (volume.box().max + volume.box().min);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      float value = row == column ? (row < 3 ? side[row] : 1.0f) : 0.0f;
      if (row < 3 && column == 3) value = centre[row];
      put(bytes, value);
    }
  }
  return bytes;
}

class VfWriter final : public FrameWriter {
 public:
  VfWriter(const BakeHeader& header, std::filesystem::path folder, int version)
      : m_track(header.track),
        m_folder(std::move(folder)),
        m_field(header.grid, kMostPerSide),
        m_volume(m_field.grid(), layersOf(header, kMostPerSide), header.track.quantity, unityPreset(header)),
        m_version(version),
        m_stem(version == 1 ? "wind" : "wind-v2") {}

  Status add(int frame, std::span<const glm::vec2> cells) override {
    m_volume.block(m_field.of(cells), m_block);
    std::string bytes;
    if (m_version == 1) {
      bytes = "VF_V";
      putSize(bytes, m_volume.size());
    } else {
      bytes = header2(m_volume);
    }
    bytes.append(reinterpret_cast<const char*>(m_block.data()), m_block.size() * sizeof(glm::vec3));
    m_files.push_back({frameFile(m_track, m_stem, frame, "vf"), "volume", "float32", detailsOf(frame)});
    return writeFileUnsynced(m_folder / m_files.back().path, bytes);
  }

  Result<std::vector<BakedFile>> finish() override { return std::move(m_files); }

 private:
  /// Version 1 has no place of its own: centre and size belong into the effect's field transform.
  [[nodiscard]] nlohmann::ordered_json detailsOf(int frame) const {
    nlohmann::ordered_json details = m_volume.details(frame);
    details["version"] = m_version;
    details["centre"] = plainTriple(0.5f * (m_volume.box().min + m_volume.box().max));
    details["size"] = plainTriple(m_volume.box().max - m_volume.box().min);
    return details;
  }

  Track m_track;
  std::filesystem::path m_folder;
  FittedField m_field;
  Volume m_volume;
  int m_version;
  std::string m_stem;
  std::vector<glm::vec3> m_block;
  std::vector<BakedFile> m_files;
};

std::uint64_t bytesOf(const BakeHeader& header, std::uint64_t headerBytes) {
  const glm::ivec2 cells = fittedResolution(header.grid.resolution, kMostPerSide);
  const std::uint64_t vectors = static_cast<std::uint64_t>(cells.x) * static_cast<std::uint64_t>(cells.y) *
                                layersOf(header, kMostPerSide).factors.size();
  return (headerBytes + vectors * sizeof(glm::vec3)) * static_cast<std::uint64_t>(header.written());
}

}  // namespace

OpenedWriter openVfWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return std::unique_ptr<FrameWriter>(std::make_unique<VfWriter>(header, folder, 1));
}

OpenedWriter openVf2Writer(const BakeHeader& header, const std::filesystem::path& folder) {
  return std::unique_ptr<FrameWriter>(std::make_unique<VfWriter>(header, folder, 2));
}

std::uint64_t vfBytes(const BakeHeader& header) {
  return bytesOf(header, kHeaderBytes);
}

std::uint64_t vf2Bytes(const BakeHeader& header) {
  return bytesOf(header, kHeader2Bytes);
}

std::string vfWarning(const BakeHeader& header) {
  return fittingWarning(header, kMostPerSide, "the most that a 3D texture of Unity has");
}

}  // namespace windloom
