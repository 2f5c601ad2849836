// 8-bit flow maps: R and G hold the vector along the target's two axes, B its length, A is 255. Code 128 is still air
// and (code - 128) / 127 * full scale the exact decoding, so that no drift comes from rounding zero.

#include "engine/bake/target_frame.hpp"
#include "engine/bake/writers.hpp"
#include "engine/io/png_stream.hpp"

namespace windloom {
namespace {

class FlowMapWriter final : public FrameWriter {
 public:
  FlowMapWriter(const BakeHeader& header, std::filesystem::path folder)
      : m_track(header.track), m_target(header), m_resolution(header.grid.resolution), m_folder(std::move(folder)) {}

  Status add(int frame, std::span<const glm::vec2> cells) override {
    m_target.image(cells, m_vectors);
    m_samples.resize(m_vectors.size() * 4);
    std::uint8_t* pixel = m_samples.data();
    for (const glm::vec2 vector : m_vectors) {
      const glm::vec2 part = partOf(vector, m_target.fullScale(), m_clipped);
      pixel[0] = signedCode8(part.x);
      pixel[1] = signedCode8(part.y);
      pixel[2] = unsignedCode8(glm::length(part));
      pixel[3] = 255;
      pixel += 4;
    }
    m_files.push_back({frameFile(m_track, "flow", frame, "png"), "flow", "unorm8", {{"frame", frame}}});
    return writePicture(m_folder / m_files.back().path);
  }

  Result<std::vector<BakedFile>> finish() override {
    warnOfClipping(m_clipped, m_target, "the flow maps");
    return std::move(m_files);
  }

 private:
  Status writePicture(const std::filesystem::path& path) const {
    auto png = PngStream<std::uint8_t>::create(path, m_resolution.x, m_resolution.y);
    if (!png) return png.error();
    if (Status written = png->write(m_samples); !written) return written;
    return png->finish(Sync::Later);
  }

  Track m_track;
  TargetFrame m_target;
  glm::ivec2 m_resolution;
  std::filesystem::path m_folder;
  std::vector<glm::vec2> m_vectors;
  std::vector<std::uint8_t> m_samples;
  std::vector<BakedFile> m_files;
  long long m_clipped = 0;
};

}  // namespace

Result<std::unique_ptr<FrameWriter>> openFlowMapWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return std::unique_ptr<FrameWriter>(std::make_unique<FlowMapWriter>(header, folder));
}

}  // namespace windloom
