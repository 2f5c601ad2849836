#include "tests/proof/field_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "shaders/shared/speed_colour.h"

namespace windloom::testing {
namespace {

constexpr int kBarHeight = 14, kGap = 8, kGlyphWidth = 5, kGlyphHeight = 7, kGlyphScale = 2;
constexpr glm::vec3 kPaper(1), kInk(0.1f), kSolid(0.52f), kSolidEdge(0.2f);
constexpr int kSamples = 2;     // a side, per pixel
constexpr float kShades = 128;  // of a map: as smooth to the eye as more, and smaller files

/// Stops of ColorBrewer's RdBu (Brewer & Harrower), sRGB.
glm::vec3 turningColour(float t) {
  constexpr std::array<glm::vec3, 5> kStops = {glm::vec3(0.020f, 0.188f, 0.380f), glm::vec3(0.263f, 0.576f, 0.765f),
                                               glm::vec3(0.969f, 0.969f, 0.969f), glm::vec3(0.839f, 0.376f, 0.302f),
                                               glm::vec3(0.404f, 0.000f, 0.122f)};
  const float at = std::clamp(t, 0.0f, 1.0f) * 4;
  const auto stop = static_cast<std::size_t>(std::min(at, 3.0f));
  return glm::mix(kStops[stop], kStops[stop + 1], at - static_cast<float>(stop));
}

/// t from 0 to 1 along the map.
glm::vec3 colourOf(ColourMap map, float t) {
  const float shade = std::round(std::clamp(t, 0.0f, 1.0f) * kShades) / kShades;
  return map == ColourMap::Speed ? shared::speedColourAt(shade) : turningColour(shade);
}

float alongMap(const FieldPicture& p, double value) {
  return static_cast<float>(p.map == ColourMap::Speed ? value / p.range : 0.5 + 0.5 * value / p.range);
}

void put(Image& image, int x, int y, glm::vec3 colour) {
  for (int c = 0; c < 3; ++c)
    image.at(x, y)[c] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(colour[c], 0.0f, 1.0f)));
}

/// Rows of a glyph from the top, its leftmost pixel in bit 4.
std::array<int, kGlyphHeight> glyph(char c) {
  switch (c) {
    case '0':
      return {14, 17, 19, 21, 25, 17, 14};
    case '1':
      return {4, 12, 4, 4, 4, 4, 14};
    case '2':
      return {14, 17, 1, 2, 4, 8, 31};
    case '3':
      return {31, 2, 4, 2, 1, 17, 14};
    case '4':
      return {2, 6, 10, 18, 31, 2, 2};
    case '5':
      return {31, 16, 30, 1, 1, 17, 14};
    case '6':
      return {6, 8, 16, 30, 17, 17, 14};
    case '7':
      return {31, 1, 2, 4, 8, 8, 8};
    case '8':
      return {14, 17, 17, 14, 17, 17, 14};
    case '9':
      return {14, 17, 17, 15, 1, 2, 12};
    case '.':
      return {0, 0, 0, 0, 0, 12, 12};
    case '-':
      return {0, 0, 0, 31, 0, 0, 0};
    case '/':
      return {0, 1, 2, 4, 8, 16, 0};
    case 'm':
      return {0, 0, 26, 21, 21, 17, 17};
    case 's':
      return {0, 0, 14, 16, 14, 1, 30};
    default:
      return {};
  }
}

void write(Image& image, int x, int y, std::string_view text) {
  for (const char c : text) {
    const auto rows = glyph(c);
    for (int py = 0; py < kGlyphHeight * kGlyphScale; ++py) {
      for (int px = 0; px < kGlyphWidth * kGlyphScale; ++px) {
        if (((rows[static_cast<std::size_t>(py / kGlyphScale)] >> (4 - px / kGlyphScale)) & 1) != 0)
          put(image, x + px, y + py, kInk);
      }
    }
    x += (kGlyphWidth + 1) * kGlyphScale;
  }
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

void drawBar(Image& image, const FieldPicture& p, int top) {
  for (int x = kGap; x < p.width - kGap; ++x) {
    const float t = (static_cast<float>(x - kGap) + 0.5f) / static_cast<float>(p.width - 2 * kGap);
    for (int y = 0; y < kBarHeight; ++y) put(image, x, top + kGap + y, colourOf(p.map, t));
  }
  const auto widthOf = [](const std::string& text) {
    return static_cast<int>(text.size()) * (kGlyphWidth + 1) * kGlyphScale - kGlyphScale;
  };
  const int y = top + 2 * kGap + kBarHeight;
  const bool speed = p.map == ColourMap::Speed;
  const std::string middle = number(speed ? p.range / 2 : 0), end = number(p.range) + " " + p.unit;
  write(image, kGap, y, number(speed ? 0 : -p.range));
  write(image, (p.width - widthOf(middle)) / 2, y, middle);
  write(image, p.width - kGap - widthOf(end), y, end);
}

}  // namespace

Image drawField(const FieldPicture& p, const WindGrid& grid, const std::function<double(glm::vec2)>& value) {
  const glm::vec2 extent = p.high - p.low;
  const float pixel = extent.x / static_cast<float>(p.width);
  const int height = static_cast<int>(std::lround(extent.y / pixel));
  Image image(p.width, height + 3 * kGap + kBarHeight + kGlyphHeight * kGlyphScale, 3);
  std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{255});
  const auto placeOf = [&](float x, float y) { return glm::vec2(p.low.x + x * pixel, p.high.y - y * pixel); };
  const auto solidAt = [&](float x, float y) {
    const glm::ivec2 cell = cellOf(grid.mapping, placeOf(x, y));
    return cell.x >= 0 && cell.y >= 0 && cell.x < grid.width && cell.y < grid.height && grid.solidAt(cell.x, cell.y);
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < p.width; ++x) {
      const auto px = static_cast<float>(x), py = static_cast<float>(y);
      if (solidAt(px + 0.5f, py + 0.5f)) {
        const bool inside = solidAt(px - 0.5f, py + 0.5f) && solidAt(px + 1.5f, py + 0.5f) &&
                            solidAt(px + 0.5f, py - 0.5f) && solidAt(px + 0.5f, py + 1.5f);
        put(image, x, y, inside ? kSolid : kSolidEdge);
        continue;
      }
      double sum = 0;
      for (int n = 0; n < kSamples * kSamples; ++n) {
        const float sx = (static_cast<float>(n % kSamples) + 0.5f) / kSamples;
        const float sy = (static_cast<float>(n / kSamples) + 0.5f) / kSamples;
        sum += value(placeOf(px + sx, py + sy));
      }
      put(image, x, y, colourOf(p.map, alongMap(p, sum / (kSamples * kSamples))));
    }
  }
  drawBar(image, p, height);
  return image;
}

}  // namespace windloom::testing
