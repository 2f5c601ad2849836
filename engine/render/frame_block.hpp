#pragma once
// The frame's uniforms from camera, project and time. Pure arithmetic.

#include "engine/render/frame_renderer.hpp"
#include "shaders/shared/frame_block.h"

namespace windloom {

using shared::FrameBlock;

/// A low warm sun; the picture's light is the same for every project.
struct Light {
  glm::vec3 sunDirection;  ///< unit vector towards the sun
  glm::vec3 sunColour;     ///< irradiance on a plane facing it, linear
  glm::vec3 skyColour;     ///< irradiance from the open sky, linear
  float exposure;
  float haze;              ///< 1/m; less over large fields
};
Light defaultLight();

/// Where the map of solids lies: the field and room around it for shadows that reach in.
struct SolidMapArea {
  glm::vec2 minCorner, size;  ///< m
};
SolidMapArea solidMapArea(const FieldSettings& field);

FrameBlock makeFrameBlock(const FrameInput& input, const Light& light);

}  // namespace windloom
