// Binding numbers of everything the renderers bind, in one place for C++ and GLSL.
#ifndef WINDLOOM_SHARED_RENDER_BINDINGS_H
#define WINDLOOM_SHARED_RENDER_BINDINGS_H

// Uniform buffers.
#define RENDER_UBO_FRAME 0
#define RENDER_UBO_GRASS 1
#define RENDER_UBO_CHAIN 2
#define RENDER_UBO_COLLIDERS 3
#define RENDER_UBO_BEZIER 4
#define RENDER_UBO_BEZIER_PHYSICS 5
#define RENDER_UBO_ROTORS 6
#define RENDER_UBO_SHELL 7

// Textures.
#define RENDER_TEXTURE_WIND 0
#define RENDER_TEXTURE_NOISE 1
#define RENDER_TEXTURE_SKY 2
#define RENDER_TEXTURE_SOLIDS 3
#define RENDER_TEXTURE_MAP 8
#define RENDER_TEXTURE_GROUND 4
#define RENDER_TEXTURE_GROUND_LIGHT 5
#define RENDER_TEXTURE_OCCLUDERS 6
#define RENDER_TEXTURE_PLANT 9
#define RENDER_TEXTURE_DENSITY_MAP 11
#define RENDER_TEXTURE_HEIGHT_MAP 12
#define RENDER_TEXTURE_COLOUR_MAP 13
#define RENDER_TEXTURE_COLLIDER 10
#define RENDER_TEXTURE_VIRTUAL_WIND 14
#define RENDER_TEXTURE_NEAR_DEPTH 15
#define RENDER_TEXTURE_SHELL_FORM 16
#define RENDER_TEXTURE_SHELL_COLOUR 17
#define RENDER_TEXTURE_SHELL_OFFSETS 18

// Storage buffers.
#define RENDER_SSBO_CHUNKS 0
#define RENDER_SSBO_BLADES 1
#define RENDER_SSBO_COMMANDS 2
#define RENDER_SSBO_SOLIDS 3
#define RENDER_SSBO_MARKS 4
#define RENDER_SSBO_LEVELS 5
#define RENDER_SSBO_SEEDS 6
#define RENDER_SSBO_LINES 7
// OpenGL promises eight; these passes have neither marks nor levels.
#define RENDER_SSBO_GROUND_TILES 4
#define RENDER_SSBO_GRASS_BOUNDS 4
#define RENDER_SSBO_CORNERS 5
// The culling of tiles has neither solids nor patches.
#define RENDER_SSBO_TILE_WORK 3
#define RENDER_SSBO_GROUP_WORK 5
#define RENDER_SSBO_CHAINS 3
// The placing of plants other than blades has no chunks, blades and solids.
#define RENDER_SSBO_PLANTS 1
#define RENDER_SSBO_PLANT_COMMANDS 2
#define RENDER_SSBO_PLANT_KINDS 3
#define RENDER_SSBO_VIRTUAL_BLADES 4
// The stepping pass of the patches. The placing passes read table and state, too: nothing else in between is bound there.
#define RENDER_SSBO_PATCHES 4
#define RENDER_SSBO_PRIMITIVES 5
#define RENDER_SSBO_PATCH_TABLE 6
#define RENDER_SSBO_PATCH_STATE 7
// The passes of Bezier grass, which have nothing of the others' but the solids.
#define RENDER_SSBO_BEZIER_BLADES 0
#define RENDER_SSBO_BEZIER_STATES 1
#define RENDER_SSBO_BEZIER_PATCHES 2
#define RENDER_SSBO_BEZIER_SEEN 4
#define RENDER_SSBO_BEZIER_LIST 5
#define RENDER_SSBO_BEZIER_COMMANDS 6
#define RENDER_SSBO_BEZIER_PRIMITIVES 7
// What wakes patches has no blades.
#define RENDER_SSBO_BEZIER_CLOCKS 0
#define RENDER_SSBO_BEZIER_DRAWN 7
// Shell grass.
#define RENDER_SSBO_SHELL_INSTANCES 0

// Images.
#define RENDER_IMAGE_VIRTUAL_WIND 0
#define RENDER_IMAGE_NEAR_DEPTH 0

#endif
