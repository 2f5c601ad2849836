#pragma once
// The texture of shell grass: cuts through blades from above, with their height in it, and smaller levels of it that
// keep some of the blades. Bakay, Lalonde & Heidrich, "Real-time animated grass", 2002, section 3; its mipmaps are that
// paper's future work. Pure and the same for the same input on any machine.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/model/project.hpp"

namespace windloom {

/// `form`: red height of the blade over this texel as ShellSettings::heightCurve codes it (0: bare ground), green the
/// height of the whole blade that the texel belongs to (the same code), blue its rank (it grows where the meadow keeps
/// more than rank / 255 of its blades; even over 0..255), alpha a number of its own (to vary its light).
/// `colour`: sRGB colour of the blade's upper part, alpha its root's brightness over that, 0..255 for 0..1.
/// Texels of bare ground have the form and colour of their nearest blade but height 0, so that filtering doesn't bleed.
struct ShellLevel {
  int side = 0;  ///< texels
  std::vector<glm::u8vec4> form, colour;
};

/// Parts of the height at which cover is known.
inline constexpr int kShellCovers = 64;
/// Side of the smallest level.
inline constexpr int kShellLeastSide = 16;

struct ShellTexture {
  std::vector<ShellLevel> levels;  ///< each half as wide as the one before, down to kShellLeastSide
  float tileM = 4.0f;              ///< side on the ground
  float tallestM = 0.5f;           ///< height that code 255 stands for
  float heightCurve = 1.0f;
  long long blades = 0;  ///< in the tile
  /// [i]: part of the area where something reaches more than i / kShellCovers of the tallest height.
  std::array<float, kShellCovers> cover{};
  glm::vec3 meanColour{0.0f};  ///< linear, of the texels with a blade
};

/// Blades of the meadow and of its species of blades (weights, patchiness in the mean) at random in the tile, with
/// clumps. At least one blade. Wraps around.
ShellTexture makeShellTexture(const GrassSettings& grass, const ShellSettings& shell, std::span<const Species> species);

/// From a picture: its alpha is the height, its colour the blades' own. `grass` gives the height that alpha 1 stands
/// for. A blade of it is what hangs together above the ground.
ShellTexture shellTextureOf(const GrassMap& picture, const GrassSettings& grass, const ShellSettings& shell);

/// Part of a level's area where something reaches more than `height` (0..1 of the tallest).
float shellCover(const ShellLevel& level, float height, float heightCurve);
/// Mean linear colour of its texels that have a blade.
glm::vec3 shellMeanColour(const ShellLevel& level);

}  // namespace windloom
