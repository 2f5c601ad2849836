// What every shader of a frame knows: camera, light, time, the field's place (std140).
#ifndef WINDLOOM_SHARED_FRAME_BLOCK_H
#define WINDLOOM_SHARED_FRAME_BLOCK_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

struct FrameBlock {
  mat4 viewProjection;
  mat4 inverseViewProjection;
  vec4 cameraPosition;  // xyz m; w 1 where the projection is orthographic, else 0
  vec4 viewForward;     // xyz unit vector the camera looks along; w s of simulated time
  vec4 sunDirection;    // xyz unit vector towards the sun; w exposure
  vec4 sunColour;       // rgb irradiance on a plane facing the sun, linear
  vec4 skyColour;       // rgb irradiance of the open sky from above, linear
  vec4 viewport;        // width, height in pixels, 1 / width, 1 / height
  vec4 pixelScale;      // x pixels a metre covers at 1 m (perspective) or anywhere (orthographic);
                        // y haze, 1/m; z m/s at the top of the speed colour map; w 1 where there is wind
  vec4 field;           // low corner x, z and size x, z, m
  vec4 fieldCells;      // cells along x, z and their size, m
  vec4 solidMap;        // low corner x, z and 1 / size x, z of the map of solids, 1/m
  vec4 groundColour;    // rgb of the bare ground, linear
  vec4 ambientWind;     // x, z m/s: the wind outside the field
  vec4 ground;          // low corner x, z of the uneven ground, m; samples a metre along x, z
  vec4 groundGrid;      // samples along x, z (0: the ground is flat at 0); its height is z + w * texel, m
  vec4 groundRange;     // lowest and highest height, m
  vec4 frustum[6];      // planes, normals inwards, normalised
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::FrameBlock) == 2 * 64 + 15 * 16 + 6 * 16, "std140 layout");
#endif
#endif
