#pragma once
// The finest level of a shell texture from a picture. Pure.

#include "engine/grass/shell_texture.hpp"

namespace windloom {

struct ShellPicture {
  ShellLevel level;
  long long blades = 0;
};

/// The picture, its alpha as the code of the height, at `side` by `side` texels, a power of two. Where it is larger the
/// highest of the pixels under a texel counts, with its colour, so that thin blades don't get lost; where it is smaller
/// the nearest one. A blade is what hangs together above the ground, over the edges of the tile as well.
ShellPicture cutShellPicture(const GrassMap& picture, const GrassSettings& grass, int side);

}  // namespace windloom
