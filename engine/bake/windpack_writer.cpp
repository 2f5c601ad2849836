// The format is described in docs/windpack.md.

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

#include "engine/bake/half.hpp"
#include "engine/bake/writers.hpp"
#include "engine/bake/zstd_stream.hpp"
#include "engine/core/atomic_file.hpp"
#include "engine/runtime/checksum.h"
#include "engine/runtime/windpack_format.h"

namespace windloom {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers go to the file as they lie in memory");

struct Packing {
  const char* stem;
  bool floats = false, zstd = false;

  [[nodiscard]] std::uint32_t cellBytes() const {
    return floats ? WINDPACK_FLOAT_CELL_BYTES : WINDPACK_HALF_CELL_BYTES;
  }
};

constexpr Packing kHalves{"wind"}, kFloats{"wind-f32", true, false}, kPacked{"wind-zstd", false, true};

template <class Number>
void put(std::string& bytes, std::size_t at, Number value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
}

std::uint64_t dataBytes(const BakeHeader& header, const Packing& packing) {
  const glm::ivec2 resolution = header.grid.resolution;
  return static_cast<std::uint64_t>(resolution.x) * static_cast<std::uint64_t>(resolution.y) *
         static_cast<std::uint64_t>(header.frames) * packing.cellBytes();
}

std::uint32_t flagsOf(const BakeHeader& header, const Packing& packing) {
  return (header.loop ? WINDPACK_FLAG_LOOP : 0u) | (header.periodicX ? WINDPACK_FLAG_WRAP_X : 0u) |
         (header.periodicZ ? WINDPACK_FLAG_WRAP_Z : 0u) | (packing.floats ? WINDPACK_FLAG_FLOAT32 : 0u) |
         (packing.zstd ? WINDPACK_FLAG_ZSTD : 0u);
}

std::string headerBytes(const BakeHeader& header, const Packing& packing) {
  const GridMapping& grid = header.grid;
  std::string bytes(WINDPACK_HEADER_BYTES, '\0');
  bytes.replace(0, 8, WINDPACK_MAGIC);
  put(bytes, WINDPACK_AT_VERSION, WINDPACK_VERSION);
  put(bytes, WINDPACK_AT_ENDIAN_MARK, WINDPACK_ENDIAN_MARK);
  put(bytes, WINDPACK_AT_FLAGS, flagsOf(header, packing));
  put(bytes, WINDPACK_AT_WIDTH, static_cast<std::uint32_t>(grid.resolution.x));
  put(bytes, WINDPACK_AT_HEIGHT, static_cast<std::uint32_t>(grid.resolution.y));
  put(bytes, WINDPACK_AT_FRAMES, static_cast<std::uint32_t>(header.frames));
  put(bytes, WINDPACK_AT_MIN_X, grid.minCorner.x);
  put(bytes, WINDPACK_AT_MIN_Z, grid.minCorner.y);
  put(bytes, WINDPACK_AT_MAX_X, grid.minCorner.x + grid.size.x);
  put(bytes, WINDPACK_AT_MAX_Z, grid.minCorner.y + grid.size.y);
  put(bytes, WINDPACK_AT_FPS, static_cast<float>(header.fps));
  put(bytes, WINDPACK_AT_MAX_SPEED,
      packing.floats ? header.fastest
                     : std::min(header.fastestHalf > 0.0f ? header.fastestHalf : header.fastest, WINDPACK_MAX_HALF));
  put(bytes, WINDPACK_AT_START, header.start);
  put(bytes, WINDPACK_AT_DATA_BYTES, dataBytes(header, packing));
  const bool wind = header.track.quantity == Quantity::Wind;
  put(bytes, WINDPACK_AT_QUANTITY, wind ? WINDPACK_QUANTITY_WIND : WINDPACK_QUANTITY_BEND);
  put(bytes, WINDPACK_AT_REFERENCE_HEIGHT, header.profile.reference);
  // How far a plant leans holds for the plant, not for a height.
  put(bytes, WINDPACK_AT_ROUGHNESS, wind ? header.profile.roughness : 0.0f);
  return bytes;
}

class WindpackWriter final : public FrameWriter {
 public:
  WindpackWriter(AtomicFile file, std::string name, const BakeHeader& header, const Packing& packing)
      : m_file(std::move(file)), m_name(std::move(name)), m_packing(packing) {
    if (!packing.zstd) return;
    m_zstd.emplace(dataBytes(header, packing), [this](std::string_view packed) { return store(packed); });
  }

  /// Bytes as they lie in the file; all but the checksum itself count for it.
  Status store(std::string_view bytes) {
    m_checksum = windloom_checksum(m_checksum, bytes.data(), bytes.size());
    return m_file.write(bytes);
  }

  Status add(int, std::span<const glm::vec2> cells) override {
    if (m_packing.floats) {
      static_assert(sizeof(glm::vec2) == WINDPACK_FLOAT_CELL_BYTES);
      return data({reinterpret_cast<const char*>(cells.data()), cells.size_bytes()});
    }
    m_halves.resize(cells.size() * 2);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      m_halves[2 * i] = halfFromFloat(cells[i].x);
      m_halves[2 * i + 1] = halfFromFloat(cells[i].y);
    }
    return data({reinterpret_cast<const char*>(m_halves.data()), m_halves.size() * sizeof(std::uint16_t)});
  }

  Result<std::vector<BakedFile>> finish() override {
    if (m_zstd) {
      if (Status packed = m_zstd->finish(); !packed) return packed.error();
    }
    const std::uint32_t checksum = m_checksum;
    if (Status written = store({reinterpret_cast<const char*>(&checksum), sizeof checksum}); !written)
      return written.error();
    if (Status finished = m_file.finish(); !finished) return finished.error();
    BakedFile file{m_name, "field", m_packing.floats ? "float32" : "half"};
    file.details["version"] = WINDPACK_VERSION;
    if (m_packing.zstd) file.details["compression"] = "zstd";
    return std::vector<BakedFile>{std::move(file)};
  }

 private:
  Status data(std::string_view bytes) { return m_zstd ? m_zstd->write(bytes) : store(bytes); }

  AtomicFile m_file;
  std::string m_name;
  Packing m_packing;
  std::optional<ZstdStream> m_zstd;
  std::uint32_t m_checksum = 0;
  std::vector<std::uint16_t> m_halves;
};

std::string refusal(const BakeHeader& header, const Packing& packing) {
  const bool holds =
      dataBytes(header, packing) <= WINDPACK_MAX_DATA_BYTES && header.frames <= static_cast<int>(WINDPACK_MAX_FRAMES);
  return holds ? "" : "a wind pack holds at most 16 GiB and 100,000 frames; bake fewer frames or a lower --resolution";
}

OpenedWriter openWindpack(const BakeHeader& header, const std::filesystem::path& folder, const Packing& packing) {
  if (const std::string reason = refusal(header, packing); !reason.empty()) {
    return makeError(ErrorKind::BadInput, reason);
  }
  const std::string name = stemOf(header.track, packing.stem) + ".windpack";
  Result<AtomicFile> file = AtomicFile::create(folder / name);
  if (!file) return file.error();
  auto writer = std::make_unique<WindpackWriter>(std::move(*file), name, header, packing);
  if (Status written = writer->store(headerBytes(header, packing)); !written) return written.error();
  return std::unique_ptr<FrameWriter>(std::move(writer));
}

}  // namespace

std::string windpackRefusal(const BakeHeader& header) {
  return refusal(header, kHalves);
}

std::string windpackFloatRefusal(const BakeHeader& header) {
  return refusal(header, kFloats);
}

OpenedWriter openWindpackWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return openWindpack(header, folder, kHalves);
}

OpenedWriter openWindpackFloatWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return openWindpack(header, folder, kFloats);
}

OpenedWriter openWindpackZstdWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return openWindpack(header, folder, kPacked);
}

}  // namespace windloom
