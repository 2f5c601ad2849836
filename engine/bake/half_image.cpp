// The loops are plain so that the compiler vectorises them; lengths need -fno-math-errno for that (CMakeLists.txt).

#include "engine/bake/half_image.hpp"

#include <algorithm>
#include <cmath>

#include "engine/bake/half.hpp"

namespace windloom {
namespace {

constexpr std::uint16_t kHalfOne = 0x3c00;

void convert(const float* values, std::size_t count, std::uint16_t* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = halfFromFloat(values[i]);
}

void toRgba(const glm::vec2* vectors, const float* lengths, std::size_t count, std::uint16_t* out) {
  for (std::size_t i = 0; i < count; ++i) {
    out[4 * i] = halfFromFloat(vectors[i].x);
    out[4 * i + 1] = halfFromFloat(vectors[i].y);
    out[4 * i + 2] = halfFromFloat(lengths[i]);
    out[4 * i + 3] = kHalfOne;
  }
}

void toRowBgr(const glm::vec2* vectors, const float* lengths, std::size_t width, std::uint16_t* out) {
  convert(lengths, width, out);
  std::uint16_t* green = out + width;
  std::uint16_t* red = green + width;
  for (std::size_t i = 0; i < width; ++i) red[i] = halfFromFloat(vectors[i].x);
  for (std::size_t i = 0; i < width; ++i) green[i] = halfFromFloat(vectors[i].y);
}

}  // namespace

int halvesPerPixel(HalfLayout layout) {
  switch (layout) {
    case HalfLayout::Rg:
      return 2;
    case HalfLayout::Rgba:
      return 4;
    case HalfLayout::RowsBgr:
      return 3;
  }
  return 0;
}

HalfImage::HalfImage(const BakeHeader& header, HalfLayout layout)
    : m_target(header), m_layout(layout), m_width(static_cast<std::size_t>(header.grid.resolution.x)) {}

void HalfImage::measureLengths() {
  m_lengths.resize(m_vectors.size());
  for (std::size_t i = 0; i < m_vectors.size(); ++i) {
    const glm::vec2 v = m_vectors[i];
    m_lengths[i] = std::sqrt(v.x * v.x + v.y * v.y);
  }
  m_longest = *std::max_element(m_lengths.begin(), m_lengths.end());
}

std::span<const std::uint16_t> HalfImage::of(std::span<const glm::vec2> cells) {
  m_target.image(cells, m_vectors);
  const std::size_t count = m_vectors.size();
  m_halves.resize(count * static_cast<std::size_t>(halvesPerPixel(m_layout)));
  if (m_layout == HalfLayout::Rg) {
    static_assert(sizeof(glm::vec2) == 2 * sizeof(float));
    convert(&m_vectors.data()->x, 2 * count, m_halves.data());
    return m_halves;
  }
  measureLengths();
  if (m_layout == HalfLayout::Rgba) {
    toRgba(m_vectors.data(), m_lengths.data(), count, m_halves.data());
    return m_halves;
  }
  for (std::size_t at = 0; at < count; at += m_width) {
    toRowBgr(m_vectors.data() + at, m_lengths.data() + at, m_width, m_halves.data() + 3 * at);
  }
  return m_halves;
}

}  // namespace windloom
