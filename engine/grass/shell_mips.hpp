#pragma once
// Smaller levels of a shell texture that keep some of its blades and leave out others, rather than mixing them: a mean
// of heights would thin the meadow out with distance. Pure.

#include "engine/grass/shell_texture.hpp"

namespace windloom {

/// Adds levels to the first one down to kShellLeastSide. Each covers as much of the ground above any height as the
/// first one does, to half a texel, and has its mean colour. `cutTexels`: how wide a blade's cut is in the mean;
/// texels wider than that stand for several blades and take on some of what these have in common in colour.
void addShellLevels(std::vector<ShellLevel>& levels, float cutTexels);

}  // namespace windloom
