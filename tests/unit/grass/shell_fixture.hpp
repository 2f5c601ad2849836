#pragma once
// Settings and pictures for tests of shell textures.

#include <set>
#include <tuple>

#include "engine/core/hash.hpp"
#include "engine/grass/shell_texture.hpp"
#include "shaders/shared/shell_bend.h"

namespace windloom::testing {

/// What the tests' numbers hold for, whatever settings begin with.
inline ShellSettings fullShell() {
  ShellSettings shell;
  shell.tile = 4.0f;
  shell.texels = 1024;
  shell.fullness = 8.0f;
  shell.thickness = 0.4f;
  shell.taper = 0.6f;
  shell.heightCurve = 1.5f;
  return shell;
}

/// A small texture with as many blades for each texel as the full one.
inline ShellSettings smallShell(int texels = 256) {
  ShellSettings shell = fullShell();
  shell.texels = texels;
  shell.tile = 4.0f * static_cast<float>(texels) / 1024.0f;
  return shell;
}

inline GrassSettings grassOf(float density, int seed = 1) {
  GrassSettings grass;
  grass.density = density;
  grass.seed = seed;
  return grass;
}

/// Blades of three looks.
inline std::vector<Species> threeSpecies() {
  std::vector<Species> species(2);
  species[0].id = 7;
  species[0].weight = 0.5f;
  species[0].height = 1.2f;
  species[0].width = 0.01f;
  species[0].tipColour = {0.6f, 0.1f, 0.05f};
  species[1].id = 8;
  species[1].weight = 0.25f;
  species[1].height = 0.2f;
  species[1].width = 0.06f;
  species[1].tipColour = {0.1f, 0.2f, 0.7f};
  return species;
}

/// `pixel(x, y)`: RGBA.
template <class Pixel>
GrassMap pictureOf(int width, int height, Pixel&& pixel) {
  GrassMap picture;
  picture.size = {width, height};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::u8vec4 value = pixel(x, y);
      for (int c = 0; c < 4; ++c) picture.pixels.push_back(value[c]);
    }
  }
  return picture;
}

inline std::uint32_t noise(int x, int y) {
  return hashCombine(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y));
}

/// The cover that a code of red stands for is known at each code.
inline float coverAbove(const ShellTexture& texture, const ShellLevel& level, int code) {
  // Half a code up: rounding of the curve must not decide on which side the code lies.
  const float height = shared::shellHeightOf((static_cast<float>(code) + 0.5f) / 255.0f, texture.heightCurve);
  return shellCover(level, height, texture.heightCurve);
}

/// What tells blades apart.
inline std::tuple<int, int> bladeOf(glm::u8vec4 form) {
  return {form.b, form.a};
}

inline bool sameBytes(const ShellTexture& a, const ShellTexture& b) {
  if (a.levels.size() != b.levels.size() || a.blades != b.blades || a.tallestM != b.tallestM) return false;
  for (std::size_t i = 0; i < a.levels.size(); ++i) {
    if (a.levels[i].form != b.levels[i].form || a.levels[i].colour != b.levels[i].colour) return false;
  }
  return a.cover == b.cover && a.meanColour == b.meanColour;
}

}  // namespace windloom::testing
