// What the passes of shell grass know: settings (std140) and what an instance draws (std430).
#ifndef WINDLOOM_SHARED_SHELL_BLOCK_H
#define WINDLOOM_SHARED_SHELL_BLOCK_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

// Quads along a tile's side.
#define SHELL_TILE_SIDE 8
#define SHELL_TILE_SIDE_QUICK 4
// A tile is drawn at distances between half of this many sides and this many; towards its far end it takes on the coarser lattice.
#define SHELL_TILE_REACH 6.0f
#define SHELL_MORPH_BEGIN 0.75f

struct ShellBlock {
  vec4 size;    // x tallest blade m; y squares of the texture a metre; z texels a metre; w coarsest level of the texture
  vec4 bend;    // x intensity a weak wind gives per m/s times pi / 4; y its limit; z by how much clumps lean; w flutter
  vec4 source;  // x, z m: of the analytic source; z strength, 0: none; w period s
  vec4 rings;   // x width of its rings m; y delay of each s; z 1 where the simulated wind blows; w stiffness exponent
  vec4 table;   // x segments of a blade; y rows of the table of offsets; z exponent of the height's code; w 1: blades are looked for
                // once a segment, where plain shells would be
  vec4 look;    // x most steps between two shells; y height in pixels at which grass has become ground, 0: never; z samples a
                // pixel; w m within which lattices have their own size, where projection is parallel, else 0
  vec4 root;    // rgb colour of a blade's root over its upper part's; w part of the texture's blades that the
                // ground has
  vec4 mean;    // rgb mean colour of the texture
};

/// A piece of a shell: a tile of the ground or a whole surface.
struct ShellInstance {
  float x;      // low corner, m; on surfaces 1, or -1 for the backs of the triangles
  float z;
  float side;   // m
  uint ends;    // segments' ends in bytes: of the shell below, down to which it shows blades; its own; of the one above
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::ShellBlock) == 8 * 16, "std140 layout");
static_assert(sizeof(windloom::shared::ShellInstance) == 16, "std430 layout");
#endif
#endif
