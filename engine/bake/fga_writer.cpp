// .fga ("fluid grid ASCII"), the vector fields that Unreal imports: numbers separated by commas, NX, NY, NZ, the low
// and the high corner in centimetres, then the vectors, x fastest. Unreal refuses more than 128 cells a side, so a
// larger grid is averaged down (fga) or cut into tiles (fga-tiles). Always in Unreal's frame, whatever the preset.

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "engine/bake/volume.hpp"
#include "engine/bake/writers.hpp"
#include "engine/core/atomic_file.hpp"

namespace windloom {
namespace {

constexpr int kMostPerSide = 128;
// 1 um/s, or 1e-6 rad; Unreal keeps half floats.
constexpr int kWindDecimals = 4, kBendDecimals = 6;
constexpr int kLengthDecimals = 4;  // 1 um

/// `value` rounded to so many decimals, without zeros at the end, whatever the locale; then a comma.
void appendNumber(std::string& text, double value, int decimals) {
  constexpr std::array<long long, 7> kScales = {1, 10, 100, 1'000, 10'000, 100'000, 1'000'000};
  const long long scale = kScales[static_cast<std::size_t>(decimals)];
  const long long code = std::llround(value * static_cast<double>(scale));
  const long long magnitude = code < 0 ? -code : code;
  std::array<char, 32> digits{};
  char* const begin = digits.data();
  if (code < 0) text += '-';
  text.append(begin, std::to_chars(begin, begin + digits.size(), magnitude / scale).ptr);
  if (magnitude % scale != 0) {
    // Adding the scale keeps the zeros between the point and the first digit; its own 1 becomes the point.
    char* end = std::to_chars(begin, begin + digits.size(), scale + magnitude % scale).ptr;
    while (end[-1] == '0') --end;
    *begin = '.';
    text.append(begin, end);
  }
  text += ',';
}

/// A part of the grid that becomes a file of its own.
struct Piece {
  std::string stem;
  glm::ivec2 tile{0}, first{0}, cells{0};
  Volume volume;
};

Piece pieceOf(const BakeHeader& header, const GridMapping& grid, glm::ivec2 first, glm::ivec2 end) {
  const GridMapping part{grid.minCorner + glm::vec2(first) * grid.cellSize, glm::vec2(end - first) * grid.cellSize,
                         end - first, grid.cellSize};
  return {
      {}, {}, first, end - first, Volume(part, layersOf(header, kMostPerSide), header.track.quantity, Preset::Unreal)};
}

int tilesAlong(int cells) {
  return (cells + kMostPerSide - 1) / kMostPerSide;
}

class FgaWriter final : public FrameWriter {
 public:
  FgaWriter(const BakeHeader& header, std::filesystem::path folder, bool tiled)
      : m_track(header.track),
        m_folder(std::move(folder)),
        m_field(header.grid, tiled ? std::numeric_limits<int>::max() : kMostPerSide),
        m_decimals(header.track.quantity == Quantity::Bend ? kBendDecimals : kWindDecimals),
        m_tiled(tiled) {
    const glm::ivec2 cells = m_field.grid().resolution;
    const glm::ivec2 tiles(tilesAlong(cells.x), tilesAlong(cells.y));
    for (int y = 0; y < tiles.y; ++y) {
      for (int x = 0; x < tiles.x; ++x) {
        const glm::ivec2 tile(x, y);
        Piece piece = pieceOf(header, m_field.grid(), tile * cells / tiles, (tile + 1) * cells / tiles);
        piece.tile = tile;
        piece.stem = tiled ? "wind_t" + std::to_string(x) + "_t" + std::to_string(y) : "wind";
        m_pieces.push_back(std::move(piece));
      }
    }
  }

  Status add(int frame, std::span<const glm::vec2> cells) override {
    const std::span<const glm::vec2> field = m_field.of(cells);
    for (const Piece& piece : m_pieces) {
      cut(piece, field);
      piece.volume.block(m_cut, m_block);
      nlohmann::ordered_json details = piece.volume.details(frame);
      if (m_tiled) details["tile"] = {piece.tile.x, piece.tile.y};
      m_files.push_back({frameFile(m_track, piece.stem, frame, "fga"), "volume", "text", std::move(details)});
      if (Status written = writeFileUnsynced(m_folder / m_files.back().path, textOf(piece.volume)); !written)
        return written;
    }
    return Done{};
  }

  Result<std::vector<BakedFile>> finish() override { return std::move(m_files); }

 private:
  void cut(const Piece& piece, std::span<const glm::vec2> field) {
    m_cut.clear();
    for (int k = 0; k < piece.cells.y; ++k) {
      const auto at = static_cast<std::ptrdiff_t>(piece.first.y + k) * m_field.grid().resolution.x + piece.first.x;
      m_cut.insert(m_cut.end(), field.begin() + at, field.begin() + at + piece.cells.x);
    }
  }

  const std::string& textOf(const Volume& volume) {
    m_text.clear();
    const glm::ivec3 size = volume.size();
    for (int axis = 0; axis < 3; ++axis) appendNumber(m_text, size[axis], 0);
    m_text += '\n';
    for (const glm::vec3 corner : {volume.box().min, volume.box().max}) {
      for (int axis = 0; axis < 3; ++axis) appendNumber(m_text, static_cast<double>(corner[axis]), kLengthDecimals);
      m_text += '\n';
    }
    for (const glm::vec3 v : m_block) {
      for (int axis = 0; axis < 3; ++axis) appendNumber(m_text, static_cast<double>(v[axis]), m_decimals);
      m_text += '\n';
    }
    // Unreal counts values; a comma after the last one looks like one more.
    m_text.replace(m_text.size() - 2, 2, "\n");
    return m_text;
  }

  Track m_track;
  std::filesystem::path m_folder;
  FittedField m_field;
  int m_decimals;
  bool m_tiled;
  std::vector<Piece> m_pieces;
  std::vector<glm::vec2> m_cut;
  std::vector<glm::vec3> m_block;
  std::string m_text;
  std::vector<BakedFile> m_files;
};

std::string layersWarning(const BakeHeader& header) {
  if (header.profile.layers <= kMostPerSide) return {};
  return std::to_string(header.profile.layers) + " layers become 128 thicker ones, the most that Unreal imports";
}

std::string joined(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + "; " + b;
}

/// Of all files: a line of text has about 20 characters.
std::uint64_t textBytes(const BakeHeader& header, glm::ivec2 cells) {
  return static_cast<std::uint64_t>(cells.x) * static_cast<std::uint64_t>(cells.y) *
         layersOf(header, kMostPerSide).factors.size() * static_cast<std::uint64_t>(header.written()) * 20;
}

}  // namespace

OpenedWriter openFgaWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return std::unique_ptr<FrameWriter>(std::make_unique<FgaWriter>(header, folder, false));
}

OpenedWriter openFgaTilesWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return std::unique_ptr<FrameWriter>(std::make_unique<FgaWriter>(header, folder, true));
}

std::uint64_t fgaBytes(const BakeHeader& header) {
  return textBytes(header, fittedResolution(header.grid.resolution, kMostPerSide));
}

std::uint64_t fgaTilesBytes(const BakeHeader& header) {
  return textBytes(header, header.grid.resolution);
}

std::string fgaWarning(const BakeHeader& header) {
  return joined(fittingWarning(header, kMostPerSide, "the most that Unreal imports; fga-tiles keeps them all"),
                layersWarning(header));
}

std::string fgaTilesWarning(const BakeHeader& header) {
  const int x = tilesAlong(header.grid.resolution.x), y = tilesAlong(header.grid.resolution.y);
  if (x * y == 1) return layersWarning(header);
  return joined(
      std::to_string(x) + " x " + std::to_string(y) + " files a frame, since Unreal imports at most 128 cells a side",
      layersWarning(header));
}

}  // namespace windloom
