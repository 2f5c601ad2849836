#pragma once
// The finest level of a shell texture: cuts through its blades. Pure.

#include "engine/grass/shell_blades.hpp"
#include "engine/grass/shell_texture.hpp"

namespace windloom {

/// Draws the blades into a level that wraps around. A blade's cut is an ellipse that narrows upwards: at part s of the
/// height its half axes are 1 - taper * s^1.5 of those at the root, so that blades keep their width low down and end
/// in a tip. Turned around: what lies r of the half axes from the root is min(((1 - r) / taper)^(2/3), 1) of the
/// height high. Where blades overlap the higher one is seen.
ShellLevel cutShellBlades(const ShellBlades& blades, int side, const ShellSettings& shell);

/// Gives texels of bare ground what the nearest texel of a blade has, counted in steps along rows and columns, but
/// height 0. Nothing happens where there is no blade at all.
void fillBareGround(ShellLevel& level);

}  // namespace windloom
