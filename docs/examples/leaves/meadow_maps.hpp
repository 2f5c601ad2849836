#pragma once
// Pictures of grass, made up when the game starts so that it needs no files.

#include <vector>

#include "maths.hpp"

namespace game {

inline constexpr int kMeadowSide = 512;  ///< texels
inline constexpr int kTurfSide = 512;

/// RGBA over the meadow, repeating: the square root of the grass's linear colour, and a smooth noise.
std::vector<unsigned char> meadowTexels(Random& random);
/// Grass from above: one channel of many short strokes, later ones lighter, over dark. Repeats.
std::vector<unsigned char> turfTexels(Random& random);

}  // namespace game
