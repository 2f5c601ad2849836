#include "engine/grass/shell_picture.hpp"

#include <algorithm>
#include <numeric>

#include "engine/core/hash.hpp"
#include "engine/grass/shell_colour.hpp"
#include "engine/grass/shell_cuts.hpp"

namespace windloom {
namespace {

using Bytes = glm::u8vec4;

Bytes pixelAt(const GrassMap& picture, int x, int y) {
  const auto i =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.x) + static_cast<std::size_t>(x));
  return {picture.pixels[i], picture.pixels[i + 1], picture.pixels[i + 2], picture.pixels[i + 3]};
}

/// The pixels along one side that lie under texel `at`: first and one past the last, at least one.
glm::ivec2 pixelsUnder(int at, int side, int pixels) {
  const int first = static_cast<int>(static_cast<long long>(at) * pixels / side);
  const int last = static_cast<int>((static_cast<long long>(at) + 1) * pixels / side);
  return {first, std::max(last, first + 1)};
}

Bytes highestUnder(const GrassMap& picture, int x, int y, int side) {
  const glm::ivec2 across = pixelsUnder(x, side, picture.size.x), down = pixelsUnder(y, side, picture.size.y);
  Bytes highest = pixelAt(picture, across.x, down.x);
  for (int v = down.x; v < down.y; ++v) {
    for (int u = across.x; u < across.y; ++u) {
      const Bytes pixel = pixelAt(picture, u, v);
      if (pixel.a > highest.a) highest = pixel;
    }
  }
  return highest;
}

/// Sets that get joined. Each is known by its smallest member.
class Sets {
 public:
  explicit Sets(std::size_t count) : m_parent(count) { std::iota(m_parent.begin(), m_parent.end(), 0u); }

  std::uint32_t find(std::uint32_t i) {
    while (m_parent[i] != i) i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    m_parent[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> m_parent;
};

/// Whole heights, ranks and numbers of what hangs together; returns how many blades that makes.
long long tellBlades(ShellLevel& level, std::uint32_t seed) {
  const auto side = static_cast<std::uint32_t>(level.side), mask = side - 1;
  Sets sets(level.form.size());
  const auto high = [&](std::uint32_t i) { return level.form[i].r > 0; };
  for (std::uint32_t i = 0; i < level.form.size(); ++i) {
    const std::uint32_t x = i & mask, right = i - x + ((x + 1) & mask), below = (i + side) % (side * side);
    if (high(i) && high(right)) sets.join(i, right);
    if (high(i) && high(below)) sets.join(i, below);
  }
  std::vector<std::uint32_t> blades;
  std::vector<std::uint8_t> tallest(level.form.size(), 0);
  for (std::uint32_t i = 0; i < level.form.size(); ++i) {
    if (!high(i)) continue;
    const std::uint32_t blade = sets.find(i);
    if (blade == i) blades.push_back(i);
    tallest[blade] = std::max(tallest[blade], level.form[i].r);
  }
  // Ranks in the order of their hashes, so that they are even however few blades there are.
  std::ranges::sort(blades, {}, [&](std::uint32_t blade) { return std::pair(hashCombine(seed, blade), blade); });
  for (std::size_t n = 0; n < blades.size(); ++n) {
    Bytes& form = level.form[blades[n]];
    form.b = static_cast<std::uint8_t>(255 * n / blades.size());
    form.a = static_cast<std::uint8_t>(pcgHash(hashCombine(seed, blades[n])) >> 24);
  }
  for (std::uint32_t i = 0; i < level.form.size(); ++i) {
    if (!high(i)) continue;
    const std::uint32_t blade = sets.find(i);
    level.form[i] = {level.form[i].r, tallest[blade], level.form[blade].b, level.form[blade].a};
  }
  return static_cast<long long>(blades.size());
}

}  // namespace

ShellPicture cutShellPicture(const GrassMap& picture, const GrassSettings& grass, int side) {
  const auto luma = [](glm::vec3 colour) { return glm::dot(colour, glm::vec3(0.2126f, 0.7152f, 0.0722f)); };
  const std::uint8_t rootLight = shellByte(luma(grass.baseColour) / std::max(luma(grass.tipColour), 1e-4f));
  ShellPicture cut;
  cut.level.side = side;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const Bytes pixel = highestUnder(picture, x, y, side);
      cut.level.form.emplace_back(pixel.a, 0, 0, 0);
      cut.level.colour.emplace_back(pixel.r, pixel.g, pixel.b, rootLight);
    }
  }
  cut.blades = tellBlades(cut.level, static_cast<std::uint32_t>(grass.seed));
  fillBareGround(cut.level);
  return cut;
}

}  // namespace windloom
