// The texture of Godot's GPUParticlesAttractorVectorField3D: a picture of slices for its importer of 3D textures. Godot
// decodes 2 * colour - 1 along the node's own axes and multiplies with its strength; the picture is 8 bits deep since
// its importer cuts PNG to that anyway. Always in Godot's frame, which is ours.

#include <cmath>

#include "engine/bake/target_frame.hpp"
#include "engine/bake/volume.hpp"
#include "engine/bake/writers.hpp"
#include "engine/core/log.hpp"
#include "engine/core/text.hpp"
#include "engine/io/image.hpp"

namespace windloom {
namespace {

// The importer takes as many slices along each side of the picture. Godot's manual suggests about 64 cells a side.
constexpr int kMostPerSide = 256;

/// Slices beside each other and below each other, all of them used (the importer would take an empty place for a
/// slice): the pair that makes the picture most nearly square.
glm::ivec2 slicesFor(glm::ivec3 size) {
  glm::ivec2 best(1, size.z);
  const auto longer = [&](glm::ivec2 slices) { return std::max(slices.x * size.x, slices.y * size.y); };
  for (int across = 2; across <= size.z; ++across) {
    const glm::ivec2 slices(across, size.z / across);
    if (slices.x * slices.y == size.z && longer(slices) < longer(best)) best = slices;
  }
  return best;
}

/// The nearest code to `part` in -1..1. Zero lies between 127 and 128: neighbours take turns, so that still air doesn't
/// drift.
std::uint8_t codeOf(float part, bool upper) {
  const float code = (part * 0.5f + 0.5f) * 255.0f;
  const float below = std::floor(code);
  const bool up = code - below == 0.5f ? upper : code - below > 0.5f;
  return static_cast<std::uint8_t>(below + (up ? 1.0f : 0.0f));
}

class SlabWriter final : public FrameWriter {
 public:
  SlabWriter(const BakeHeader& header, std::filesystem::path folder)
      : m_track(header.track),
        m_folder(std::move(folder)),
        m_field(header.grid, kMostPerSide),
        m_volume(m_field.grid(), layersOf(header, kMostPerSide), header.track.quantity, Preset::Godot),
        m_slices(slicesFor(m_volume.size())),
        m_strength(header.fullScale * m_volume.fastestFactor()),
        m_image(m_slices.x * m_volume.size().x, m_slices.y * m_volume.size().y, 3) {}

  Status add(int frame, std::span<const glm::vec2> cells) override {
    m_volume.block(m_field.of(cells), m_block);
    paint();
    m_files.push_back({frameFile(m_track, "slab", frame, "png"), "volume", "unorm8", detailsOf(frame)});
    return writePng(m_folder / m_files.back().path, m_image);
  }

  Result<std::vector<BakedFile>> finish() override {
    if (m_clipped > 0) {
      logWarning(std::to_string(m_clipped) +
                 " cells of the slabs are over the chosen full scale and were shortened to it");
    }
    return std::move(m_files);
  }

 private:
  void paint() {
    const glm::ivec3 size = m_volume.size();
    const glm::vec3* vector = m_block.data();
    for (int z = 0; z < size.z; ++z) {
      const glm::ivec2 corner(z % m_slices.x * size.x, z / m_slices.x * size.y);
      for (int y = 0; y < size.y; ++y) {
        std::uint8_t* pixel = m_image.at(corner.x, corner.y + y);
        for (int x = 0; x < size.x; ++x, pixel += 3, ++vector) {
          const glm::vec2 part = partOf({vector->x, vector->z}, m_strength, m_clipped);
          const bool upper = (x + y + z) % 2 == 1;
          pixel[0] = codeOf(part.x, upper);
          pixel[1] = codeOf(0.0f, upper);
          pixel[2] = codeOf(part.y, upper);
        }
      }
    }
  }

  [[nodiscard]] nlohmann::ordered_json detailsOf(int frame) const {
    nlohmann::ordered_json details = m_volume.details(frame);
    details["slices"] = {m_slices.x, m_slices.y};
    details["full_scale"] = details["strength"] = plainTriple(glm::vec3(m_strength))[0];
    details["decode"] = "(2 * code / 255 - 1) * strength";
    details["centre"] = plainTriple(0.5f * (m_volume.box().min + m_volume.box().max));
    details["size"] = plainTriple(m_volume.box().max - m_volume.box().min);
    details["import"] = {{"importer", "3d_texture"},     {"type", "CompressedTexture3D"},
                         {"compress/mode", 3},           {"compress/channel_pack", 1},
                         {"mipmaps/generate", false},    {"slices/horizontal", m_slices.x},
                         {"slices/vertical", m_slices.y}};
    return details;
  }

  Track m_track;
  std::filesystem::path m_folder;
  FittedField m_field;
  Volume m_volume;
  glm::ivec2 m_slices;
  float m_strength;
  Image m_image;
  std::vector<glm::vec3> m_block;
  std::vector<BakedFile> m_files;
  long long m_clipped = 0;
};

}  // namespace

OpenedWriter openSlabWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return std::unique_ptr<FrameWriter>(std::make_unique<SlabWriter>(header, folder));
}

/// At most: pictures shrink.
std::uint64_t slabBytes(const BakeHeader& header) {
  const glm::ivec2 cells = fittedResolution(header.grid.resolution, kMostPerSide);
  return static_cast<std::uint64_t>(cells.x) * static_cast<std::uint64_t>(cells.y) *
         layersOf(header, kMostPerSide).factors.size() * 3 * static_cast<std::uint64_t>(header.written());
}

std::string slabWarning(const BakeHeader& header) {
  return fittingWarning(header, kMostPerSide, "the most slices that Godot imports");
}

}  // namespace windloom
