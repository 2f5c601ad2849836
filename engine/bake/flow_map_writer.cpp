// 8-bit flow maps: R and G hold the velocity along the target's two ground axes, B the speed, A is 255. Code 128 is
// still air and (code - 128) / 127 * range the exact decoding, so that no drift comes from rounding zero.

#include <algorithm>
#include <cmath>

#include "engine/bake/frame_writer.hpp"
#include "engine/core/log.hpp"
#include "engine/core/text.hpp"
#include "engine/io/image.hpp"

namespace windloom {
namespace {

std::uint8_t signedCode(float part) {
  return static_cast<std::uint8_t>(128 + std::clamp(static_cast<int>(std::lround(part * 127.0f)), -127, 127));
}

std::uint8_t unsignedCode(float part) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0f, 1.0f) * 255.0f));
}

/// "flow.0007.png"; more digits from frame 10,000 on.
std::string frameName(int frame) {
  std::string number = std::to_string(frame);
  if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
  return "flow." + number + ".png";
}

class FlowMapWriter final : public FrameWriter {
 public:
  FlowMapWriter(const BakeHeader& header, std::filesystem::path folder)
      : m_header(header),
        m_rules(rulesOf(header.preset)),
        m_folder(std::move(folder)),
        m_image(header.grid.resolution.x, header.grid.resolution.y, 4) {}

  Status add(int frame, std::span<const glm::vec2> cells) override {
    const glm::ivec2 resolution = m_header.grid.resolution;
    for (int row = 0; row < resolution.y; ++row) {
      for (int column = 0; column < resolution.x; ++column) {
        const glm::ivec2 cell = cellOfPixel(m_rules, {column, row}, resolution);
        encode(cells[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(resolution.x) +
                     static_cast<std::size_t>(cell.x)],
               m_image.at(column, row));
      }
    }
    m_files.push_back({frameName(frame), "flow", "unorm8"});
    return writePng(m_folder / m_files.back().path, m_image);
  }

  Result<std::vector<BakedFile>> finish() override {
    if (m_clipped > 0) {
      logWarning(std::to_string(m_clipped) + " cells of the flow maps are faster than the chosen " +
                 fixed(static_cast<double>(m_header.speedRange), 2) + " m/s and were slowed to it");
    }
    return std::move(m_files);
  }

 private:
  void encode(glm::vec2 velocity, std::uint8_t* pixel) {
    glm::vec2 part = velocityIn(m_rules, velocity) / m_header.speedRange;
    float speed = glm::length(part);
    if (speed > 1.0f) {
      // A part in 10,000 is far below one code: rounding, not clipping.
      if (speed > 1.0001f) ++m_clipped;
      part /= speed;
      speed = 1.0f;
    }
    pixel[0] = signedCode(part.x);
    pixel[1] = signedCode(part.y);
    pixel[2] = unsignedCode(speed);
    pixel[3] = 255;
  }

  BakeHeader m_header;
  const PresetRules& m_rules;
  std::filesystem::path m_folder;
  Image m_image;
  std::vector<BakedFile> m_files;
  long long m_clipped = 0;
};

}  // namespace

Result<std::unique_ptr<FrameWriter>> openFlowMapWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return std::unique_ptr<FrameWriter>(std::make_unique<FlowMapWriter>(header, folder));
}

}  // namespace windloom
