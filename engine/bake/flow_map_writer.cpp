// Flow maps of 8 or 16 bits: R and G hold the vector along the target's two axes, B its length, A is full. Code 128
// (32768) is still air and (code - 128) / 127 * full scale the exact decoding, so that no drift comes from rounding
// zero.

#include <limits>

#include "engine/bake/target_frame.hpp"
#include "engine/bake/writers.hpp"
#include "engine/io/png_stream.hpp"

namespace windloom {
namespace {

/// What differs between the depths.
struct EightBits {
  using Sample = std::uint8_t;
  static constexpr const char* stem = "flow";
  static constexpr const char* encoding = "unorm8";
  static constexpr const char* words = "the flow maps";
  static Sample signedCode(float part) { return signedCode8(part); }
  static Sample unsignedCode(float part) { return unsignedCode8(part); }
};
struct SixteenBits {
  using Sample = std::uint16_t;
  static constexpr const char* stem = "flow16";
  static constexpr const char* encoding = "unorm16";
  static constexpr const char* words = "the 16-bit flow maps";
  static Sample signedCode(float part) { return signedCode16(part); }
  static Sample unsignedCode(float part) { return unsignedCode16(part); }
};

template <class Depth>
class FlowMapWriter final : public FrameWriter {
 public:
  FlowMapWriter(const BakeHeader& header, std::filesystem::path folder)
      : m_track(header.track), m_target(header), m_resolution(header.grid.resolution), m_folder(std::move(folder)) {}

  Status add(int frame, std::span<const glm::vec2> cells) override {
    m_target.image(cells, m_vectors);
    m_samples.resize(m_vectors.size() * 4);
    Sample* pixel = m_samples.data();
    for (const glm::vec2 vector : m_vectors) {
      const glm::vec2 part = partOf(vector, m_target.fullScale(), m_clipped);
      pixel[0] = Depth::signedCode(part.x);
      pixel[1] = Depth::signedCode(part.y);
      pixel[2] = Depth::unsignedCode(glm::length(part));
      pixel[3] = std::numeric_limits<Sample>::max();
      pixel += 4;
    }
    m_files.push_back({frameFile(m_track, Depth::stem, frame, "png"), "flow", Depth::encoding, {{"frame", frame}}});
    return writePicture(m_folder / m_files.back().path);
  }

  Result<std::vector<BakedFile>> finish() override {
    warnOfClipping(m_clipped, m_target, Depth::words);
    return std::move(m_files);
  }

 private:
  using Sample = typename Depth::Sample;

  Status writePicture(const std::filesystem::path& path) const {
    auto png = PngStream<Sample>::create(path, m_resolution.x, m_resolution.y);
    if (!png) return png.error();
    if (Status written = png->write(m_samples); !written) return written;
    return png->finish(Sync::Later);
  }

  Track m_track;
  TargetFrame m_target;
  glm::ivec2 m_resolution;
  std::filesystem::path m_folder;
  std::vector<glm::vec2> m_vectors;
  std::vector<Sample> m_samples;
  std::vector<BakedFile> m_files;
  long long m_clipped = 0;
};

}  // namespace

OpenedWriter openFlowMapWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return std::unique_ptr<FrameWriter>(std::make_unique<FlowMapWriter<EightBits>>(header, folder));
}

OpenedWriter openPng16Writer(const BakeHeader& header, const std::filesystem::path& folder) {
  return std::unique_ptr<FrameWriter>(std::make_unique<FlowMapWriter<SixteenBits>>(header, folder));
}

}  // namespace windloom
