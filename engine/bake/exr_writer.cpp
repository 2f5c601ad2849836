// Half-float EXR pictures, one a frame: the master recording that every tool reads.

#include "engine/bake/exr_file.hpp"
#include "engine/bake/flow_facts.hpp"
#include "engine/bake/half_image.hpp"
#include "engine/bake/writers.hpp"
#include "engine/core/text.hpp"

namespace windloom {
namespace {

class ExrFrameWriter final : public FrameWriter {
 public:
  ExrFrameWriter(const BakeHeader& header, std::filesystem::path folder)
      : m_header(header),
        m_folder(std::move(folder)),
        m_image(header, HalfLayout::RowsBgr),
        m_exr(header.grid.resolution) {}

  Status add(int frame, std::span<const glm::vec2> cells) override {
    const std::span<const std::uint16_t> rows = m_image.of(cells);
    ExrAttributes facts = flowFacts(m_header, m_image.target());
    facts.emplace_back("frame", std::to_string(frame));
    facts.emplace_back("time", shortest(m_header.start + frame / m_header.fps));
    // Of this picture alone, so that a part of a recording has the same bytes as in the whole.
    facts.emplace_back("vmax", shortest(m_image.longest()));
    m_files.push_back({frameFile(m_header.track, "wind", frame, "exr"),
                       "flow",
                       "half",
                       {{"frame", frame}, {"channels", "RGB"}, {"units", m_image.target().unit()}}});
    return m_exr.write(m_folder / m_files.back().path, facts, rows);
  }

  Result<std::vector<BakedFile>> finish() override { return std::move(m_files); }

 private:
  BakeHeader m_header;
  std::filesystem::path m_folder;
  HalfImage m_image;
  ExrWriter m_exr;
  std::vector<BakedFile> m_files;
};

}  // namespace

std::uint64_t exrBytes(const BakeHeader& header) {
  return exrBytesAtMost(header.grid.resolution) * static_cast<std::uint64_t>(header.written());
}

OpenedWriter openExrWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return std::unique_ptr<FrameWriter>(std::make_unique<ExrFrameWriter>(header, folder));
}

}  // namespace windloom
