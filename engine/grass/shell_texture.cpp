// Bakay, Lalonde & Heidrich, "Real-time animated grass", 2002, section 3: one texture with heights makes all shells.
#include "engine/grass/shell_texture.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/grass/shell_blades.hpp"
#include "engine/grass/shell_colour.hpp"
#include "engine/grass/shell_cuts.hpp"
#include "engine/grass/shell_mips.hpp"
#include "engine/grass/shell_picture.hpp"
#include "shaders/shared/shell_bend.h"

namespace windloom {
namespace {

constexpr int kLeastTexels = 64, kMostTexels = 1024;

/// The nearest power of two.
int sideOf(int texels) {
  const auto wanted = static_cast<unsigned>(std::clamp(texels, kLeastTexels, kMostTexels));
  const unsigned below = std::bit_floor(wanted);
  return static_cast<int>(wanted - below > 2 * below - wanted ? 2 * below : below);
}

/// The largest code that isn't higher than `height`.
int lastCodeUnder(float height, float heightCurve) {
  return static_cast<int>(255.0f * shared::shellAlphaOf(std::clamp(height, 0.0f, 1.0f), heightCurve));
}

/// ShellTexture::cover.
std::array<float, kShellCovers> coverOf(const ShellLevel& level, float heightCurve) {
  std::array<std::size_t, 256> texels{};
  for (const glm::u8vec4 form : level.form) ++texels[form.r];
  std::array<float, kShellCovers> cover{};
  std::size_t above = 0, code = texels.size();
  for (std::size_t i = cover.size(); i-- > 0;) {
    const int under = lastCodeUnder(static_cast<float>(i) / kShellCovers, heightCurve);
    while (code > static_cast<std::size_t>(under) + 1) above += texels[--code];
    cover[i] = static_cast<float>(above) / static_cast<float>(level.form.size());
  }
  return cover;
}

/// Everything that follows from the first level, the tile and the blades.
void finish(ShellTexture& texture) {
  const ShellLevel& first = texture.levels.front();
  texture.cover = coverOf(first, texture.heightCurve);
  texture.meanColour = shellMeanColour(first);
  const float covered = texture.cover[0] * static_cast<float>(first.form.size());
  addShellLevels(texture.levels, std::sqrt(covered / static_cast<float>(std::max(texture.blades, 1LL))));
}

}  // namespace

ShellTexture makeShellTexture(const GrassSettings& grass, const ShellSettings& shell,
                              std::span<const Species> species) {
  const int side = sideOf(shell.texels);
  const ShellBlades blades = growShellBlades(grass, shell, species, shell.tile / static_cast<float>(side));
  ShellTexture texture;
  texture.levels.push_back(cutShellBlades(blades, side, shell));
  texture.tileM = shell.tile;
  texture.tallestM = blades.tallestM;
  texture.heightCurve = shell.heightCurve;
  texture.blades = static_cast<long long>(blades.blades.size());
  finish(texture);
  return texture;
}

ShellTexture shellTextureOf(const GrassMap& picture, const GrassSettings& grass, const ShellSettings& shell) {
  ShellPicture cut = cutShellPicture(picture, grass, sideOf(shell.texels));
  ShellTexture texture;
  texture.levels.push_back(std::move(cut.level));
  texture.tileM = shell.tile;
  texture.tallestM = std::max(grass.height * (1.0f + grass.heightVariation), 1e-3f);
  texture.heightCurve = shell.heightCurve;
  texture.blades = cut.blades;
  finish(texture);
  return texture;
}

float shellCover(const ShellLevel& level, float height, float heightCurve) {
  const int under = lastCodeUnder(height, heightCurve);
  const auto above = std::ranges::count_if(level.form, [&](glm::u8vec4 form) { return form.r > under; });
  return static_cast<float>(above) / static_cast<float>(std::max(level.form.size(), std::size_t{1}));
}

glm::vec3 shellMeanColour(const ShellLevel& level) {
  const SrgbCodes codes;
  glm::dvec3 blades(0.0), all(0.0);
  std::size_t count = 0;
  for (std::size_t i = 0; i < level.form.size(); ++i) {
    const glm::dvec3 colour(codes.linear(level.colour[i]));
    all += colour;
    if (level.form[i].r == 0) continue;
    blades += colour;
    ++count;
  }
  if (count > 0) return glm::vec3(blades / static_cast<double>(count));
  return glm::vec3(all / static_cast<double>(std::max(level.form.size(), std::size_t{1})));
}

}  // namespace windloom
