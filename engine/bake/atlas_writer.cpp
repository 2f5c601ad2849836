// All frames as tiles of one 8-bit picture, coded as the flow maps are. A row of tiles is written as soon as it is
// full, so that only that much is held.

#include "engine/bake/atlas_layout.hpp"
#include "engine/bake/target_frame.hpp"
#include "engine/bake/writers.hpp"
#include "engine/io/png_stream.hpp"

namespace windloom {
namespace {

using Stream = PngStream<std::uint8_t>;

class AtlasWriter final : public FrameWriter {
 public:
  AtlasWriter(const BakeHeader& header, glm::ivec2 tiles, std::string name, Stream stream)
      : m_target(header),
        m_tile(header.grid.resolution),
        m_tiles(tiles),
        m_frames(header.frames),
        m_name(std::move(name)),
        m_stream(std::move(stream)) {
    clearRow();
  }

  Status add(int, std::span<const glm::vec2> cells) override {
    m_target.image(cells, m_vectors);
    const auto width = static_cast<std::size_t>(m_tile.x);
    for (std::size_t row = 0; row < static_cast<std::size_t>(m_tile.y); ++row) {
      std::uint8_t* pixel = pixelOf(m_column, row);
      for (std::size_t i = 0; i < width; ++i, pixel += 4) {
        const glm::vec2 part = partOf(m_vectors[row * width + i], m_target.fullScale(), m_clipped);
        pixel[0] = signedCode8(part.x);
        pixel[1] = signedCode8(part.y);
        pixel[2] = unsignedCode8(glm::length(part));
      }
    }
    if (++m_column < m_tiles.x) return Done{};
    return writeRow();
  }

  Result<std::vector<BakedFile>> finish() override {
    if (m_column > 0) {
      if (Status written = writeRow(); !written) return written.error();
    }
    if (Status finished = m_stream.finish(Sync::Later); !finished) return finished.error();
    warnOfClipping(m_clipped, m_target, "the atlas");
    return std::vector<BakedFile>{
        {m_name, "flow", "unorm8", {{"layout", "atlas"}, {"frames", m_frames}, {"tiles", {m_tiles.x, m_tiles.y}}}}};
  }

 private:
  std::uint8_t* pixelOf(int column, std::size_t row) {
    const std::size_t rowPixels = static_cast<std::size_t>(m_tiles.x) * static_cast<std::size_t>(m_tile.x);
    return &m_pixels[4 * (row * rowPixels + static_cast<std::size_t>(column) * static_cast<std::size_t>(m_tile.x))];
  }

  /// Still air, which is what tiles without a frame hold.
  void clearRow() {
    m_column = 0;
    m_pixels.resize(4 * static_cast<std::size_t>(m_tiles.x) * static_cast<std::size_t>(m_tile.x) *
                    static_cast<std::size_t>(m_tile.y));
    for (std::size_t i = 0; i < m_pixels.size(); i += 4) {
      m_pixels[i] = m_pixels[i + 1] = 128;
      m_pixels[i + 2] = 0;
      m_pixels[i + 3] = 255;
    }
  }

  Status writeRow() {
    Status written = m_stream.write(m_pixels);
    clearRow();
    return written;
  }

  TargetFrame m_target;
  glm::ivec2 m_tile, m_tiles;
  int m_frames;
  std::string m_name;
  Stream m_stream;
  int m_column = 0;
  std::vector<glm::vec2> m_vectors;
  std::vector<std::uint8_t> m_pixels;  // of one row of tiles
  long long m_clipped = 0;
};

}  // namespace

std::string atlasRefusal(const BakeHeader& header) {
  const glm::ivec2 tile = header.grid.resolution;
  if (atlasTiles(header.frames, tile)) return {};
  const glm::ivec2 most = glm::ivec2(kMaxAtlasSide) / tile;
  const std::string limit = std::to_string(kMaxAtlasSide);
  return "an atlas of at most " + limit + " x " + limit + " pixels holds " + std::to_string(most.x * most.y) +
         " frames of " + std::to_string(tile.x) + " x " + std::to_string(tile.y) + ", not " +
         std::to_string(header.frames) + "; bake fewer frames or a lower --resolution";
}

OpenedWriter openAtlasWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  if (std::string refusal = atlasRefusal(header); !refusal.empty()) return makeError(ErrorKind::BadInput, refusal);
  const glm::ivec2 tiles = *atlasTiles(header.frames, header.grid.resolution);
  const glm::ivec2 pixels = tiles * header.grid.resolution;
  const std::string name = stemOf(header.track, "flow-atlas") + ".png";
  Result<Stream> stream = Stream::create(folder / name, pixels.x, pixels.y);
  if (!stream) return stream.error();
  return std::unique_ptr<FrameWriter>(std::make_unique<AtlasWriter>(header, tiles, name, std::move(*stream)));
}

}  // namespace windloom
