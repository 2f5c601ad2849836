#include "engine/grass/shell_cuts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/grass/shell_colour.hpp"
#include "shaders/shared/shell_bend.h"

namespace windloom {
namespace {

constexpr std::size_t kProfileParts = 256, kHeightParts = 1024;
constexpr float kTaperPower = 1.5f;
constexpr float kLeastRadius = 0.5f;  // texels

/// Tables for what is needed at each texel of each blade.
class CutTables {
 public:
  explicit CutTables(const ShellSettings& shell) {
    const float taper = std::clamp(shell.taper, 0.0f, 1.0f);
    for (std::size_t i = 0; i < kProfileParts; ++i) {
      const float r = std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(kProfileParts));
      m_profile[i] = r <= 1.0f - taper ? 1.0f : std::pow((1.0f - r) / taper, 1.0f / kTaperPower);
    }
    for (std::size_t code = 1; code < 255; ++code) {
      m_between[code - 1] = shared::shellHeightOf((static_cast<float>(code) + 0.5f) / 255.0f, shell.heightCurve);
    }
    for (std::size_t i = 0; i < m_first.size(); ++i) {
      const float height = static_cast<float>(i) / static_cast<float>(kHeightParts);
      m_first[i] = static_cast<std::uint8_t>(1 + (std::ranges::upper_bound(m_between, height) - m_between.begin()));
    }
  }

  /// Part of the blade's height at the root of `squared` of the half axes from its middle, squared below 1.
  [[nodiscard]] float profile(float squared) const {
    return m_profile[static_cast<std::size_t>(squared * static_cast<float>(kProfileParts))];
  }
  /// `height` over the tallest, 0..1. Never 0, which is bare ground.
  [[nodiscard]] std::uint8_t code(float height) const {
    std::uint8_t code = m_first[static_cast<std::size_t>(std::min(height, 1.0f) * static_cast<float>(kHeightParts))];
    while (code < 255 && height >= m_between[code - 1u]) ++code;
    return code;
  }

 private:
  std::array<float, kProfileParts> m_profile{};
  std::array<float, 254> m_between{};                    ///< heights between codes 1 and 2, 2 and 3 and so on
  std::array<std::uint8_t, kHeightParts + 1> m_first{};  ///< code at each of so many heights, to begin with
};

struct Pixel {
  glm::u8vec4 form, colour;
};

class Cutter {
 public:
  Cutter(ShellLevel& level, const ShellSettings& shell) : m_level(level), m_tables(shell) {}

  /// `perM`: texels, `perHeight`: 1 over the tallest.
  void cut(const ShellBlade& blade, float perM, float perHeight) {
    const float height = std::min(blade.height * perHeight, 1.0f);
    Pixel pixel{{0, m_tables.code(height), blade.rank, blade.own},
                {m_codes.code(blade.colour.r), m_codes.code(blade.colour.g), m_codes.code(blade.colour.b),
                 shellByte(blade.rootLight)}};
    const glm::vec2 root = blade.root * perM;
    const float side = static_cast<float>(m_level.side);
    const glm::vec2 radii = glm::clamp(blade.radii * perM, kLeastRadius, 0.5f * side);
    const glm::vec2 across(-blade.along.y, blade.along.x);
    // Half of its box: no more than half of the tile, so that no texel is met twice.
    const glm::vec2 reach =
        glm::min(glm::sqrt(radii.x * radii.x * blade.along * blade.along + radii.y * radii.y * across * across),
                 glm::vec2(0.5f * side - 0.5f));
    const glm::ivec2 low(glm::ceil(root - reach - 0.5f)), high(glm::floor(root + reach - 0.5f));
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        const std::size_t at = indexOf(x, y);
        if (m_level.form[at].r >= pixel.form.g) continue;
        const glm::vec2 away = glm::vec2(x, y) + 0.5f - root;
        const float u = glm::dot(away, blade.along) / radii.x, v = glm::dot(away, across) / radii.y;
        const float squared = u * u + v * v;
        if (squared >= 1.0f) continue;
        pixel.form.r = m_tables.code(height * m_tables.profile(squared));
        put(at, pixel);
      }
    }
    // However the texels lie, it has its whole height somewhere.
    pixel.form.r = pixel.form.g;
    put(indexOf(static_cast<int>(root.x), static_cast<int>(root.y)), pixel);
  }

 private:
  ShellLevel& m_level;
  CutTables m_tables;
  SrgbCodes m_codes;

  [[nodiscard]] std::size_t indexOf(int x, int y) const {
    const int mask = m_level.side - 1;
    return static_cast<std::size_t>((y & mask) * m_level.side + (x & mask));
  }

  void put(std::size_t at, const Pixel& pixel) {
    if (m_level.form[at].r >= pixel.form.r) return;
    m_level.form[at] = pixel.form;
    m_level.colour[at] = pixel.colour;
  }
};

}  // namespace

ShellLevel cutShellBlades(const ShellBlades& blades, int side, const ShellSettings& shell) {
  const auto texels = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  ShellLevel level{side, std::vector<glm::u8vec4>(texels, glm::u8vec4(0)),
                   std::vector<glm::u8vec4>(texels, glm::u8vec4(0))};
  Cutter cutter(level, shell);
  for (const ShellBlade& blade : blades.blades) {
    cutter.cut(blade, static_cast<float>(side) / shell.tile, 1.0f / blades.tallestM);
  }
  fillBareGround(level);
  return level;
}

void fillBareGround(ShellLevel& level) {
  const auto side = static_cast<std::uint32_t>(level.side), mask = side - 1;
  std::vector<std::uint32_t> reached;
  reached.reserve(level.form.size());
  std::vector<bool> known(level.form.size(), false);
  for (std::uint32_t i = 0; i < level.form.size(); ++i) {
    if (level.form[i].r == 0) continue;
    known[i] = true;
    reached.push_back(i);
  }
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const std::uint32_t from = reached[next], x = from & mask, row = from - x;
    const std::uint32_t beside[] = {row + ((x + 1) & mask), row + ((x + mask) & mask), (row + side) % (side * side) + x,
                                    (row + side * mask) % (side * side) + x};
    for (const std::uint32_t to : beside) {
      if (known[to]) continue;
      known[to] = true;
      level.form[to] = level.form[from];
      level.form[to].r = 0;
      level.colour[to] = level.colour[from];
      reached.push_back(to);
    }
  }
}

}  // namespace windloom
