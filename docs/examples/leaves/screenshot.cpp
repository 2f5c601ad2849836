#include "screenshot.hpp"

// A PNG without compression needs no library: zlib's format allows blocks that are stored as they are (RFC
// 1951, 3.2.4).

#include <epoxy/gl.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace game {

namespace {

using Bytes = std::vector<std::uint8_t>;

void addBig(Bytes& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

std::uint32_t crc32(const std::uint8_t* bytes, std::size_t count) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> made{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      made[i] = i;
      for (int bit = 0; bit < 8; ++bit) made[i] = made[i] >> 1 ^ (made[i] & 1 ? 0xEDB88320u : 0u);
    }
    return made;
  }();
  std::uint32_t crc = ~0u;
  for (std::size_t i = 0; i < count; ++i) crc = table[(crc ^ bytes[i]) & 255] ^ crc >> 8;
  return ~crc;
}

void addChunk(Bytes& png, const char* type, const Bytes& data) {
  addBig(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = png.size();
  png.insert(png.end(), type, type + 4);
  png.insert(png.end(), data.begin(), data.end());
  addBig(png, crc32(&png[start], png.size() - start));
}

Bytes stored(const Bytes& data) {
  constexpr std::size_t kLargest = 65535;
  Bytes out{0x78, 0x01};
  std::uint32_t a = 1, b = 0;  // Adler-32
  for (std::size_t at = 0; at < data.size(); at += kLargest) {
    const std::size_t size = std::min(kLargest, data.size() - at);
    const auto low = static_cast<std::uint8_t>(size), high = static_cast<std::uint8_t>(size >> 8);
    const bool last = at + size == data.size();
    for (int byte : {last ? 1 : 0, int{low}, int{high}, ~low & 255, ~high & 255})
      out.push_back(static_cast<std::uint8_t>(byte));
    out.insert(out.end(), data.begin() + static_cast<std::ptrdiff_t>(at),
               data.begin() + static_cast<std::ptrdiff_t>(at + size));
  }
  for (const std::uint8_t byte : data) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  addBig(out, b << 16 | a);
  return out;
}

}  // namespace

bool saveScreenshot(const std::string& path, int width, int height) {
  Bytes pixels(static_cast<std::size_t>(width) * height * 3);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());

  Bytes rows;  // OpenGL's first row is the lowest, PNG's the highest; each begins with its filter, 0 for none
  rows.reserve(pixels.size() + height);
  const std::ptrdiff_t stride = std::ptrdiff_t{width} * 3;
  for (std::ptrdiff_t y = height - 1; y >= 0; --y) {
    rows.push_back(0);
    rows.insert(rows.end(), pixels.begin() + y * stride, pixels.begin() + (y + 1) * stride);
  }
  Bytes header;
  addBig(header, static_cast<std::uint32_t>(width));
  addBig(header, static_cast<std::uint32_t>(height));
  for (int byte : {8, 2, 0, 0, 0}) header.push_back(static_cast<std::uint8_t>(byte));  // 8 bits a channel, RGB

  Bytes png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  addChunk(png, "IHDR", header);
  addChunk(png, "IDAT", stored(rows));
  addChunk(png, "IEND", {});
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return false;
  const bool whole = std::fwrite(png.data(), 1, png.size(), file) == png.size();
  return std::fclose(file) == 0 && whole;
}

}  // namespace game
