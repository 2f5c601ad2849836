#pragma once
// Pictures in memory and PNG files. Samples are plain numbers: no colour space is applied or written.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/core/result.hpp"

namespace windloom {

/// Width x height samples of `channels` interleaved components, row 0 at the top.
template <class Sample>
struct BasicImage {
  int width = 0, height = 0;
  int channels = 4;  ///< 1 gray, 3 RGB, 4 RGBA
  std::vector<Sample> pixels;

  BasicImage() = default;
  /// All samples zero.
  BasicImage(int w, int h, int c)
      : width(w),
        height(h),
        channels(c),
        pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(c)) {}

  /// First component of the pixel in column x of row y, which must be inside.
  Sample* at(int x, int y) { return pixels.data() + offset(x, y); }
  const Sample* at(int x, int y) const { return pixels.data() + offset(x, y); }

 private:
  [[nodiscard]] std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(channels);
  }
};

using Image = BasicImage<std::uint8_t>;
using Image16 = BasicImage<std::uint16_t>;

inline constexpr int kMaxImageSide = 32768;               ///< pixels
inline constexpr std::int64_t kMaxImagePixels = 1 << 27;  ///< 512 MB of 8-bit RGBA

/// Any PNG file, as gray, RGB or RGBA: palettes and gray with alpha are expanded, samples are brought to
/// the asked depth. Fails with BadInput where the file is missing, damaged, cut short, no PNG or over the
/// limits above.
Result<Image> readPng(const std::filesystem::path& path);
Result<Image16> readPng16(const std::filesystem::path& path);
/// The same for a PNG file within another one; `file` and `pointer` say where, for messages.
Result<Image> decodePng(std::span<const unsigned char> bytes, const std::string& file, const std::string& pointer);

/// Writes atomically. `image` must have 1, 3 or 4 channels, be within the limits and hold all its
/// samples (a contract). Fails with Machine.
Status writePng(const std::filesystem::path& path, const Image& image);
Status writePng(const std::filesystem::path& path, const Image16& image);

}  // namespace windloom
