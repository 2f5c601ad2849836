// 16-bit flow maps: as the 8-bit ones, with code 32768 for still air and (code - 32768) / 32767 * full scale.

#include "engine/bake/target_frame.hpp"
#include "engine/bake/writers.hpp"
#include "engine/io/png_stream.hpp"

namespace windloom {
namespace {

class Png16Writer final : public FrameWriter {
 public:
  Png16Writer(const BakeHeader& header, std::filesystem::path folder)
      : m_track(header.track), m_target(header), m_resolution(header.grid.resolution), m_folder(std::move(folder)) {}

  Status add(int frame, std::span<const glm::vec2> cells) override {
    m_target.image(cells, m_vectors);
    m_samples.resize(m_vectors.size() * 4);
    std::uint16_t* pixel = m_samples.data();
    for (const glm::vec2 vector : m_vectors) {
      const glm::vec2 part = partOf(vector, m_target.fullScale(), m_clipped);
      pixel[0] = signedCode16(part.x);
      pixel[1] = signedCode16(part.y);
      pixel[2] = unsignedCode16(glm::length(part));
      pixel[3] = 65535;
      pixel += 4;
    }
    m_files.push_back({frameFile(m_track, "flow16", frame, "png"), "flow", "unorm16", {{"frame", frame}}});
    return writePicture(m_folder / m_files.back().path);
  }

  Result<std::vector<BakedFile>> finish() override {
    warnOfClipping(m_clipped, m_target, "the 16-bit flow maps");
    return std::move(m_files);
  }

 private:
  Status writePicture(const std::filesystem::path& path) const {
    auto png = PngStream<std::uint16_t>::create(path, m_resolution.x, m_resolution.y);
    if (!png) return png.error();
    if (Status written = png->write(m_samples); !written) return written;
    return png->finish(Sync::Later);
  }

  Track m_track;
  TargetFrame m_target;
  glm::ivec2 m_resolution;
  std::filesystem::path m_folder;
  std::vector<glm::vec2> m_vectors;
  std::vector<std::uint16_t> m_samples;
  std::vector<BakedFile> m_files;
  long long m_clipped = 0;
};

}  // namespace

OpenedWriter openPng16Writer(const BakeHeader& header, const std::filesystem::path& folder) {
  return std::unique_ptr<FrameWriter>(std::make_unique<Png16Writer>(header, folder));
}

}  // namespace windloom
