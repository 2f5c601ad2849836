// PNG pictures by every reader: 8 and 16 bits, heights of ground, maps of grass, pictures of blades. The mutator puts
// checksums right, and mutates the pixels before they are packed, since no mutation of packed bytes finds anything.

#include <zlib.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "engine/io/assets.hpp"
#include "engine/io/image.hpp"
#include "engine/io/terrain_file.hpp"
#include "tests/fuzz/support/fuzz_target.hpp"

using namespace windloom;
using fuzz::require;

namespace {

constexpr std::size_t kSignature = 8, kChunkRim = 12;  // length, kind and checksum of a chunk
using Bytes = std::vector<std::uint8_t>;

template <class Sample>
void checkImage(const BasicImage<Sample>& image) {
  require(image.width > 0 && image.height > 0 && image.width <= kMaxImageSide && image.height <= kMaxImageSide,
          "a picture has a size");
  require(image.channels == 1 || image.channels == 3 || image.channels == 4, "a picture is grey, RGB or RGBA");
  require(image.pixels.size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                                     static_cast<std::size_t>(image.channels),
          "a picture has all its pixels");
}

void checkMap(const GrassMap& map) {
  require(map.size.x > 0 && map.size.y > 0 && map.size.x <= kMaxGrassMap && map.size.y <= kMaxGrassMap,
          "a map has a size");
  require(
      map.pixels.size() == std::size_t(4) * static_cast<std::size_t>(map.size.x) * static_cast<std::size_t>(map.size.y),
      "a map has all its pixels");
}

std::uint32_t bigAt(const Bytes& bytes, std::size_t at) {
  return std::uint32_t(bytes[at]) << 24 | std::uint32_t(bytes[at + 1]) << 16 | std::uint32_t(bytes[at + 2]) << 8 |
         bytes[at + 3];
}

void appendBig(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

struct Chunk {
  Bytes kind, data;
};

std::vector<Chunk> chunksOf(const Bytes& bytes) {
  std::vector<Chunk> chunks;
  for (std::size_t at = kSignature; at + kChunkRim <= bytes.size();) {
    const std::size_t length = std::min<std::size_t>(bigAt(bytes, at), bytes.size() - at - kChunkRim);
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    chunks.push_back({Bytes(begin + 4, begin + 8), Bytes(begin + 8, begin + 8 + static_cast<std::ptrdiff_t>(length))});
    at += kChunkRim + length;
  }
  return chunks;
}

Bytes joined(const std::vector<Chunk>& chunks) {
  Bytes bytes{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  for (const Chunk& chunk : chunks) {
    appendBig(bytes, static_cast<std::uint32_t>(chunk.data.size()));
    const std::size_t checked = bytes.size();
    bytes.insert(bytes.end(), chunk.kind.begin(), chunk.kind.end());
    bytes.insert(bytes.end(), chunk.data.begin(), chunk.data.end());
    appendBig(bytes,
              static_cast<std::uint32_t>(crc32(0, bytes.data() + checked, static_cast<uInt>(bytes.size() - checked))));
  }
  return bytes;
}

void mutatePlain(Bytes& bytes, std::size_t room) {
  const std::size_t size = bytes.size();
  bytes.resize(size + room);
  bytes.resize(LLVMFuzzerMutate(bytes.data(), size, bytes.size()));
}

/// Unpacks, mutates and packs again; as it was where it can't be unpacked.
void mutatePacked(Bytes& packed, std::size_t room) {
  Bytes rows(std::size_t(1) << 16);
  uLongf length = rows.size();
  if (uncompress(rows.data(), &length, packed.data(), packed.size()) != Z_OK) return mutatePlain(packed, room);
  rows.resize(length);
  mutatePlain(rows, 64);
  Bytes again(compressBound(rows.size()));
  length = again.size();
  if (compress(again.data(), &length, rows.data(), rows.size()) != Z_OK) return;
  again.resize(length);
  packed = std::move(again);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  const Bytes exact(data, data + size);
  const Result<Image> eight = decodePng(exact, "fuzz", "/images/0");
  if (eight) checkImage(*eight);
  const std::filesystem::path file = folder.put("fuzz.png", fuzz::asText(data, size));
  const Result<Image16> sixteen = readPng16(file);
  if (sixteen) checkImage(*sixteen);
  require(eight.ok() == sixteen.ok(), "8 and 16 bits are read alike");
  const Result<std::shared_ptr<GrassMap>> map = readGrassMap(file);
  if (map) checkMap(**map);
  require(map.ok() == sixteen.ok(), "every picture is a map");
  if (const Result<std::shared_ptr<GrassMap>> blades = readShellPicture(file)) checkMap(**blades);
  if (const Result<std::shared_ptr<HeightSource>> ground = readTerrainFile(file, TerrainKind::HeightMap)) {
    for (const float value : (*ground)->values) require(value >= 0.0f && value <= 1.0f, "a height is from 0 to 1");
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
  std::vector<Chunk> chunks = chunksOf(Bytes(data, data + size));
  if (chunks.empty() || seed % 16 == 0) return LLVMFuzzerMutate(data, size, maxSize);
  const std::size_t room = maxSize > size ? maxSize - size : 0;
  Chunk& chunk = chunks[seed / 64 % chunks.size()];
  switch (seed / 16 % 8) {
    case 0:
      chunks.erase(chunks.begin() + (&chunk - chunks.data()));
      break;
    case 1:
      chunks.insert(chunks.begin(), Chunk(chunk));
      break;
    case 2:
      std::swap(chunk, chunks.back());
      break;
    default:
      if (std::memcmp(chunk.kind.data(), "IDAT", 4) == 0) {
        mutatePacked(chunk.data, room);
      } else {
        mutatePlain(chunk.data, std::min<std::size_t>(room, 64));
      }
  }
  const Bytes made = joined(chunks);
  if (made.size() > maxSize) return size;
  std::memcpy(data, made.data(), made.size());
  return made.size();
}
