// Representative blades rather than means of them is what Bakay, Lalonde & Heidrich, "Real-time animated grass", 2002,
// name as future work. How: each texel takes over one of the four finer ones. As long as blades are wider than texels
// it is the same of the four everywhere, which keeps their shapes; then of four neighbouring texels one takes the
// lowest, one the second and so on, by chance which: less is left to chance than in four free choices. Either way any
// finer texel is as likely to stay as any other, which keeps all that blades have in common. What chance is left in the
// heights is taken out by giving them, in their order, the first level's (histogram specification); in the colours by a
// factor.
#include "engine/grass/shell_mips.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "engine/core/hash.hpp"
#include "engine/grass/shell_colour.hpp"
#include "engine/grass/shell_cuts.hpp"

namespace windloom {
namespace {

constexpr float kMostAlike = 0.75f;  // share of the mean in a texel's colour
constexpr std::size_t kCodes = 256;

/// Which finer texel a texel takes over.
enum class Choice {
  Place,   ///< the same one of four everywhere: keeps the shapes of blades that are wider than a texel
  Chance,  ///< one of four neighbouring texels the lowest, one the second and so on
};

using Histogram = std::array<std::size_t, kCodes>;

/// Light of the blades in each texel, and in .a how many of the first level's texels they cover.
using Light = std::vector<glm::vec4>;

Histogram heightsOf(const ShellLevel& level) {
  Histogram histogram{};
  for (const glm::u8vec4 form : level.form) ++histogram[form.r];
  return histogram;
}

Light lightOf(const ShellLevel& level, const SrgbCodes& codes) {
  Light light(level.form.size(), glm::vec4(0.0f));
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (level.form[i].r > 0) light[i] = glm::vec4(codes.linear(level.colour[i]), 1.0f);
  }
  return light;
}

/// The four finer texels of a texel.
std::array<std::size_t, 4> finerOf(std::size_t texel, std::size_t side) {
  const std::size_t x = texel % side, y = texel / side, first = 4 * side * y + 2 * x;
  return {first, first + 1, first + 2 * side, first + 2 * side + 1};
}

Light halved(const Light& finer, std::size_t side) {
  Light light(side * side);
  for (std::size_t i = 0; i < light.size(); ++i) {
    const auto from = finerOf(i, side);
    light[i] = finer[from[0]] + finer[from[1]] + finer[from[2]] + finer[from[3]];
  }
  return light;
}

/// For each texel the finer one that it takes over.
std::vector<std::size_t> representatives(const ShellLevel& finer, std::size_t side, Choice choice) {
  std::vector<std::size_t> chosen(side * side);
  if (choice == Choice::Place) {
    // By turns the first and the last of the four, so that levels don't wander off.
    const std::size_t place = std::countr_zero(side) % 2 == 0 ? 0 : 3;
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = finerOf(i, side)[place];
    return chosen;
  }
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const std::size_t x = i % side, y = i / side;
    const std::uint32_t group =
        hashCombine(static_cast<std::uint32_t>(side), static_cast<std::uint32_t>((y / 2) * side + x / 2));
    // A turn and a swap of the four: which of them takes which.
    const std::size_t place = (2 * (y & 1) + (x & 1) + (group & 3u)) & 3u;
    const std::size_t wanted = (group & 4u) != 0 && place % 2 == 1 ? place ^ 2u : place;
    auto from = finerOf(i, side);
    std::rotate(from.begin(), from.begin() + (pcgHash(group + static_cast<std::uint32_t>(i)) & 3u), from.end());
    // Sorted by insertion: four are too few for anything else.
    for (std::size_t k = 1; k < 4; ++k) {
      for (std::size_t n = k; n > 0 && finer.form[from[n]].r < finer.form[from[n - 1]].r; --n) {
        std::swap(from[n], from[n - 1]);
      }
    }
    chosen[i] = from[wanted];
  }
  return chosen;
}

/// The texels in the order of their heights; of the same height those first where less is around. No direction and no
/// corner comes first.
std::vector<std::uint32_t> inOrder(const ShellLevel& finer, const std::vector<std::size_t>& chosen, std::size_t side) {
  const std::size_t count = chosen.size();
  std::vector<std::uint32_t> order(count), sorted(count);
  // An odd factor and a power of two: each comes once.
  for (std::size_t i = 0; i < count; ++i)
    order[i] = static_cast<std::uint32_t>((i * 0x9e3779b1u + 0x7f4a7c15u) % count);
  const auto sortBy = [&](const auto& code) {
    std::array<std::size_t, kCodes + 1> first{};
    for (const std::uint32_t i : order) ++first[code(i) + 1u];
    for (std::size_t c = 1; c <= kCodes; ++c) first[c] += first[c - 1];
    for (const std::uint32_t i : order) sorted[first[code(i)]++] = i;
    order.swap(sorted);
  };
  sortBy([&](std::uint32_t i) {
    std::size_t sum = 0;
    for (const std::size_t from : finerOf(i, side)) sum += finer.form[from].r;
    return sum / 4;
  });
  sortBy([&](std::uint32_t i) { return static_cast<std::size_t>(finer.form[chosen[i]].r); });
  return order;
}

/// Of the finer texels the one whose height is nearest.
std::size_t nearestOf(const ShellLevel& finer, std::size_t texel, std::size_t side, int height) {
  const auto from = finerOf(texel, side);
  return *std::ranges::min_element(from, {}, [&](std::size_t i) { return std::abs(finer.form[i].r - height); });
}

ShellLevel nextLevel(const ShellLevel& finer, const Histogram& wanted, std::size_t texels, Choice choice) {
  const auto side = static_cast<std::size_t>(finer.side) / 2;
  const std::vector<std::size_t> chosen = representatives(finer, side, choice);
  const std::vector<std::uint32_t> order = inOrder(finer, chosen, side);
  ShellLevel level{finer.side / 2, std::vector<glm::u8vec4>(side * side), std::vector<glm::u8vec4>(side * side)};
  std::size_t code = 0, below = wanted[0];
  for (std::size_t p = 0; p < order.size(); ++p) {
    // The height that the first level has at the middle of this texel's part of all.
    while (below * 2 * order.size() <= (2 * p + 1) * texels && code + 1 < kCodes) below += wanted[++code];
    const std::uint32_t at = order[p];
    std::size_t from = chosen[at];
    if (finer.form[from].r != code) from = nearestOf(finer, at, side, static_cast<int>(code));
    level.form[at] = finer.form[from];
    level.form[at].r = static_cast<std::uint8_t>(code);
    level.form[at].g = std::max(level.form[at].g, level.form[at].r);
    level.colour[at] = finer.colour[from];
  }
  return level;
}

/// Gives a level its colours: `own` of each texel's blade, drawn by `alike` to the mean of the blades that the texel
/// stands for, times what brings their mean to `wanted`. What rounding takes from one texel the next one gets.
void colourLevel(ShellLevel& level, const Light& light, float alike, glm::vec3 wanted, const SrgbCodes& codes) {
  std::vector<glm::vec3> colours(level.form.size());
  glm::dvec3 sum(0.0);
  std::size_t blades = 0;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    colours[i] = codes.linear(level.colour[i]);
    if (light[i].a > 0.0f) colours[i] = glm::mix(colours[i], glm::vec3(light[i]) / light[i].a, alike);
    if (level.form[i].r == 0) continue;
    sum += glm::dvec3(colours[i]);
    ++blades;
  }
  if (blades == 0) return;
  const glm::vec3 factor = wanted / glm::max(glm::vec3(sum / static_cast<double>(blades)), glm::vec3(1e-5f));
  glm::vec3 left(0.0f);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    if (level.form[i].r == 0) continue;
    const glm::vec3 colour = colours[i] * factor + left;
    for (int c = 0; c < 3; ++c) {
      level.colour[i][c] = codes.code(colour[c]);
      left[c] = colour[c] - codes.linear(level.colour[i][c]);
    }
  }
}

}  // namespace

void addShellLevels(std::vector<ShellLevel>& levels, float cutTexels) {
  const SrgbCodes codes;
  const Histogram wanted = heightsOf(levels.front());
  const glm::vec3 meanColour = shellMeanColour(levels.front());
  const std::size_t texels = levels.front().form.size();
  Light light = lightOf(levels.front(), codes);
  // Blades are taken over with their own colours, so that these don't get mixed again and again.
  ShellLevel own = levels.front();
  for (float width = 2.0f; levels.back().side > kShellLeastSide; width *= 2.0f) {
    own = nextLevel(own, wanted, texels, width <= cutTexels ? Choice::Place : Choice::Chance);
    light = halved(light, static_cast<std::size_t>(own.side));
    ShellLevel level = own;
    const float part = width / std::max(cutTexels, 1.0f);
    colourLevel(level, light, kMostAlike * (part * part) / (1.0f + part * part), meanColour, codes);
    fillBareGround(level);
    levels.push_back(std::move(level));
  }
}

}  // namespace windloom
