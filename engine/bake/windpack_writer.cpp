// The format is described in docs/windpack.md.

#include <bit>
#include <cstring>

#include "engine/bake/half.hpp"
#include "engine/bake/writers.hpp"
#include "engine/io/atomic_file.hpp"
#include "engine/runtime/checksum.h"
#include "engine/runtime/windpack_format.h"

namespace windloom {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers go to the file as they lie in memory");

template <class Number>
void put(std::string& bytes, std::size_t at, Number value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

std::string headerBytes(const BakeHeader& header) {
  const GridMapping& grid = header.grid;
  std::string bytes(WINDPACK_HEADER_BYTES, '\0');
  bytes.replace(0, 8, WINDPACK_MAGIC);
  put(bytes, WINDPACK_AT_VERSION, WINDPACK_VERSION);
  put(bytes, WINDPACK_AT_ENDIAN_MARK, WINDPACK_ENDIAN_MARK);
  put(bytes, WINDPACK_AT_FLAGS,
      (header.loop ? WINDPACK_FLAG_LOOP : 0u) | (header.periodicX ? WINDPACK_FLAG_WRAP_X : 0u) |
          (header.periodicZ ? WINDPACK_FLAG_WRAP_Z : 0u));
  put(bytes, WINDPACK_AT_WIDTH, static_cast<std::uint32_t>(grid.resolution.x));
  put(bytes, WINDPACK_AT_HEIGHT, static_cast<std::uint32_t>(grid.resolution.y));
  put(bytes, WINDPACK_AT_FRAMES, static_cast<std::uint32_t>(header.frames));
  put(bytes, WINDPACK_AT_MIN_X, grid.minCorner.x);
  put(bytes, WINDPACK_AT_MIN_Z, grid.minCorner.y);
  put(bytes, WINDPACK_AT_MAX_X, grid.minCorner.x + grid.size.x);
  put(bytes, WINDPACK_AT_MAX_Z, grid.minCorner.y + grid.size.y);
  put(bytes, WINDPACK_AT_FPS, static_cast<float>(header.fps));
  put(bytes, WINDPACK_AT_MAX_SPEED, header.fastest);
  put(bytes, WINDPACK_AT_START, header.start);
  put(bytes, WINDPACK_AT_DATA_BYTES,
      static_cast<std::uint64_t>(grid.resolution.x) * static_cast<std::uint64_t>(grid.resolution.y) *
          static_cast<std::uint64_t>(header.frames) * WINDPACK_BYTES_PER_CELL);
  return bytes;
}

class WindpackWriter final : public FrameWriter {
 public:
  WindpackWriter(AtomicFile file, std::string name) : m_file(std::move(file)), m_name(std::move(name)) {}

  Status write(std::string_view bytes) {
    m_checksum = windloom_checksum(m_checksum, bytes.data(), bytes.size());
    return m_file.write(bytes);
  }

  Status add(int, std::span<const glm::vec2> cells) override {
    m_halves.resize(cells.size() * 2);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      m_halves[2 * i] = halfFromFloat(cells[i].x);
      m_halves[2 * i + 1] = halfFromFloat(cells[i].y);
    }
    return write({reinterpret_cast<const char*>(m_halves.data()), m_halves.size() * sizeof(std::uint16_t)});
  }

  Result<std::vector<BakedFile>> finish() override {
    const std::uint32_t checksum = m_checksum;
    if (Status written = write({reinterpret_cast<const char*>(&checksum), sizeof checksum}); !written)
      return written.error();
    if (Status finished = m_file.finish(); !finished) return finished.error();
    return std::vector<BakedFile>{{m_name, "field", "half"}};
  }

 private:
  AtomicFile m_file;
  std::string m_name;
  std::uint32_t m_checksum = 0;
  std::vector<std::uint16_t> m_halves;
};

}  // namespace

Result<std::unique_ptr<FrameWriter>> openWindpackWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  const glm::ivec2 resolution = header.grid.resolution;
  const std::uint64_t bytes = static_cast<std::uint64_t>(resolution.x) * static_cast<std::uint64_t>(resolution.y) *
                              static_cast<std::uint64_t>(header.frames) * WINDPACK_BYTES_PER_CELL;
  if (bytes > WINDPACK_MAX_DATA_BYTES || header.frames > static_cast<int>(WINDPACK_MAX_FRAMES)) {
    return makeError(ErrorKind::BadInput,
                     "a wind pack holds at most 16 GiB and 100,000 frames; bake fewer frames or a lower --resolution");
  }
  Result<AtomicFile> file = AtomicFile::create(folder / (stemOf(header.track, "wind") + ".windpack"));
  if (!file) return file.error();
  auto writer = std::make_unique<WindpackWriter>(std::move(*file), stemOf(header.track, "wind") + ".windpack");
  if (Status written = writer->write(headerBytes(header)); !written) return written.error();
  return std::unique_ptr<FrameWriter>(std::move(writer));
}

}  // namespace windloom
