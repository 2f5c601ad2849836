// After "OpenEXR File Layout" (openexr.com, technical documentation of version 2 files). A block of 16 rows is packed
// in three steps: bytes of even places first, then those of odd ones; each byte less its forerunner, plus 128; zlib. A
// block that doesn't get smaller lies there as it was.

#include "engine/bake/exr_file.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <cstring>

#include "engine/bake/little_endian.hpp"
#include "engine/core/atomic_file.hpp"
#include "engine/core/contract.hpp"
#include "engine/core/thread_pool.hpp"

namespace windloom {
namespace {

/// Of libdeflate, 1 to 12. Half-float RGB of a meadow's wind, 1000 x 1000, on one core: 1: 217 MB/s to 37.4 % of the
/// bytes, 2: 152 to 35.9, 4: 123 to 35.3, 6: 79 to 34.5. (zlib's 1: 105 to 39.4; its 4, OpenEXR's choice: 78 to 36.2.)
constexpr int kLevel = 1;

constexpr std::uint32_t kMagic = 0x01312f76;
constexpr std::uint32_t kVersion = 2;  // one part of scanlines, short names
constexpr std::int32_t kHalfPixels = 1;
constexpr std::uint8_t kZipOf16Rows = 3;

void appendAttribute(std::string& bytes, const std::string& name, const char* type, const std::string& value) {
  bytes.append(name.c_str(), name.size() + 1);
  bytes.append(type, std::strlen(type) + 1);
  appendNumber(bytes, static_cast<std::int32_t>(value.size()));
  bytes += value;
}

std::string channelList() {
  std::string bytes;
  for (const char* name : {"B", "G", "R"}) {  // in the order of the alphabet, as the format wants it
    bytes.append(name, 2);
    bytes += numberBytes(kHalfPixels, std::int32_t{0}, std::int32_t{1}, std::int32_t{1});
  }
  bytes += '\0';
  return bytes;
}

int blocksOf(glm::ivec2 resolution) {
  return (resolution.y + kExrRowsPerBlock - 1) / kExrRowsPerBlock;
}

/// The two reversible steps before zlib.
void prepare(const unsigned char* from, std::size_t count, unsigned char* to) {
  unsigned char* even = to;
  unsigned char* odd = to + (count + 1) / 2;
  for (std::size_t i = 0; i < count / 2; ++i) {
    even[i] = from[2 * i];
    odd[i] = from[2 * i + 1];
  }
  for (std::size_t i = count - 1; i > 0; --i) to[i] = static_cast<unsigned char>(to[i] - to[i - 1] + 128);
}

/// What one thread works with.
struct Packer {
  std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor{
      libdeflate_alloc_compressor(kLevel), libdeflate_free_compressor};
  std::vector<unsigned char> prepared, packed;

  /// A view that stays until the next call: of the packed bytes, or of `bytes` where packing doesn't help.
  std::string_view pack(std::string_view bytes) {
    prepared.resize(bytes.size());
    packed.resize(bytes.size());  // more wouldn't be taken
    prepare(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), prepared.data());
    const std::size_t size =
        libdeflate_zlib_compress(compressor.get(), prepared.data(), bytes.size(), packed.data(), packed.size());
    if (size == 0 || size >= bytes.size()) return bytes;
    return {reinterpret_cast<const char*>(packed.data()), size};
  }
};

}  // namespace

std::string exrHeader(glm::ivec2 resolution, const ExrAttributes& attributes) {
  std::string bytes = numberBytes(kMagic, kVersion);
  const std::string window = numberBytes(0, 0, resolution.x - 1, resolution.y - 1);
  appendAttribute(bytes, "channels", "chlist", channelList());
  appendAttribute(bytes, "compression", "compression", numberBytes(kZipOf16Rows));
  appendAttribute(bytes, "dataWindow", "box2i", window);
  appendAttribute(bytes, "displayWindow", "box2i", window);
  appendAttribute(bytes, "lineOrder", "lineOrder", numberBytes(std::uint8_t{0}));
  appendAttribute(bytes, "pixelAspectRatio", "float", numberBytes(1.0f));
  appendAttribute(bytes, "screenWindowCenter", "v2f", numberBytes(0.0f, 0.0f));
  appendAttribute(bytes, "screenWindowWidth", "float", numberBytes(1.0f));
  for (const auto& [name, text] : attributes) {
    WL_REQUIRE(!name.empty() && name.size() < 32, "names in an EXR file have 1 to 31 characters");
    appendAttribute(bytes, name, "string", text);
  }
  bytes += '\0';
  return bytes;
}

std::uint64_t exrBytesAtMost(glm::ivec2 resolution) {
  const auto blocks = static_cast<std::uint64_t>(blocksOf(resolution));
  const std::uint64_t pixels = static_cast<std::uint64_t>(resolution.x) * static_cast<std::uint64_t>(resolution.y);
  return exrHeader(resolution, {}).size() + 1024 + blocks * 16 + pixels * 6;
}

struct ExrWriter::State {
  explicit State(glm::ivec2 size) : resolution(size) {}
  glm::ivec2 resolution;
  ThreadPool pool;
  std::vector<Packer> packers;      // one a thread
  std::vector<std::string> blocks;  // packed, with their row and size before them
};

ExrWriter::ExrWriter(glm::ivec2 resolution) : m_state(std::make_unique<State>(resolution)) {
  const int blocks = blocksOf(resolution);
  m_state->blocks.resize(static_cast<std::size_t>(blocks));
  m_state->packers.resize(static_cast<std::size_t>(std::min(m_state->pool.threads(), blocks)));
}

ExrWriter::~ExrWriter() = default;

Status ExrWriter::write(const std::filesystem::path& path, const ExrAttributes& attributes,
                        std::span<const std::uint16_t> rows) {
  const std::size_t rowHalves = 3 * static_cast<std::size_t>(m_state->resolution.x);
  WL_REQUIRE(rows.size() == rowHalves * static_cast<std::size_t>(m_state->resolution.y), "a picture has all its rows");
  const auto packBlock = [&](Packer& packer, int block) {
    const int first = block * kExrRowsPerBlock;
    const int count = std::min(kExrRowsPerBlock, m_state->resolution.y - first);
    const std::uint16_t* from = rows.data() + static_cast<std::size_t>(first) * rowHalves;
    const std::string_view packedRows = packer.pack(
        {reinterpret_cast<const char*>(from), static_cast<std::size_t>(count) * rowHalves * sizeof(std::uint16_t)});
    std::string& out = m_state->blocks[static_cast<std::size_t>(block)];
    out = numberBytes(std::int32_t{first}, static_cast<std::int32_t>(packedRows.size()));
    out += packedRows;
  };
  const int lanes = static_cast<int>(m_state->packers.size());
  m_state->pool.parallelFor(lanes, [&](int lane) {
    for (int block = lane; block < blocksOf(m_state->resolution); block += lanes) {
      packBlock(m_state->packers[static_cast<std::size_t>(lane)], block);
    }
  });

  std::string start = exrHeader(m_state->resolution, attributes);
  std::uint64_t offset = start.size() + m_state->blocks.size() * sizeof offset;
  for (const std::string& block : m_state->blocks) {
    appendNumber(start, offset);
    offset += block.size();
  }
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  if (Status written = file->write(start); !written) return written;
  for (const std::string& block : m_state->blocks) {
    if (Status written = file->write(block); !written) return written;
  }
  return file->finish(Sync::Later);
}

}  // namespace windloom
