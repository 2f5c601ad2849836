// The table of shell grass.

#include <array>

#include "engine/model/parameters.hpp"

namespace windloom {
namespace {

using Names = std::string_view;
constexpr std::array<Names, 2> kShellMethods{"filled", "plain"};
constexpr std::array<Names, 3> kShellWinds{"field", "source", "both"};
constexpr std::array<Names, 2> kShellSamplings{"vertex", "texel"};

constexpr double kFar = 1e6;

}  // namespace

template <>
std::span<const Parameter<ShellSettings>> parametersOf<ShellSettings>() {
  using S = ShellSettings;
  static constexpr std::array kTable{
      integer<&S::shells>("shells", "Shells", "", 1, 128, 1,
                          "Layers over the ground near the camera; filled draws fewer of them farther away."),
      choice<&S::method>("method", "Method", kShellMethods,
                         "Filled shows what lies between two shells as well, so that a few do; plain draws even cuts "
                         "through the blades and needs many."),
      real<&S::tile>(
          "texture/tile", "Tile", "m", 0.25, 64, 0.25,
          "Side of the square of blades that repeats over the ground; smaller is finer, but repeats sooner."),
      integer<&S::texels>("texture/texels", "Texels", "", 64, 1024, 64,
                          "Points along the tile's side, made a power of two: more are finer and take more memory."),
      real<&S::fullness>("texture/fullness", "Fullness", "", 0.1, 100, 0.1,
                         "Blades for each one that the density asks for; without a picture."),
      real<&S::thickness>("texture/thickness", "Thickness", "", 0.05, 1, 0.01,
                          "Thickness of a blade over its width; without a picture."),
      real<&S::taper>("texture/taper", "Taper", "", 0, 1, 0.01,
                      "How much a blade narrows: 0 is as thick at its top as at its root, 1 ends in a point; without a "
                      "picture."),
      real<&S::heightCurve>("texture/heightCurve", "Height curve", "", 1, 4, 0.05,
                            "How the 255 heights of the texture are spread: 1 is even, more is finer near the tips."),
      text<&S::texture>("texture/file", "Picture",
                        "PNG picture of the blades from above, below the project's folder: their colours, and in alpha "
                        "how high they are; without one they are made."),
      real<&S::stiffnessCurve>("bend/stiffnessCurve", "Stiffness curve", "", 0.1, 8, 0.05,
                               "Where blades bend: 1 evenly, less low down as floppy ones do, more near their tips."),
      real<&S::overBend>(
          "bend/overBend", "Over-bending", "", 1, 2, 0.01,
          "How far the strongest wind bends: 1 lays the tips level, more bends them down to the ground."),
      real<&S::lean>("bend/lean", "Lean", "", 0, 1, 0.01, "How far clumps lean in still air."),
      choice<&S::wind>("wind/source", "Wind source", kShellWinds,
                       "The project's wind, rings of wind that swing around a place, or both added."),
      real<&S::windStrength>("wind/strength", "Wind strength", "", 0, 10, 0.01,
                             "How strongly the project's wind bends, times the wind factor."),
      choice<&S::sampling>("wind/sampling", "Wind sampling", kShellSamplings,
                           "Wind at the corners of the shells' triangles, or at every pixel: finer gusts, but dearer."),
      real<&S::source>("wind/sourcePosition", "Source position", "m", -kFar, kFar, 0.1,
                       "Place that the rings swing away from and towards (x, z); source."),
      real<&S::sourceStrength>("wind/sourceStrength", "Source strength", "", 0, 2, 0.01,
                               "Bend at the crest of a ring: 1 lays the tips level; source."),
      real<&S::sourcePeriod>("wind/sourcePeriod", "Source period", "s", 0.05, 600, 0.1,
                             "Time of one swing there and back; source."),
      real<&S::sourceStep>("wind/sourceStep", "Ring width", "m", 0.05, 1000, 0.1,
                           "Width of the rings that swing alike; source."),
      real<&S::sourceDelay>("wind/sourceDelay", "Ring delay", "s", 0, 60, 0.01,
                            "How much later each ring swings than the one inside it; source.")};
  return kTable;
}

}  // namespace windloom
