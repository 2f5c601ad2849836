#pragma once
// How uneven ground lies in the light: slopes, and the shadows that hills cast. Pure arithmetic.

#include <vector>

#include "engine/model/height_field.hpp"

namespace windloom {

/// For each sample of the field x and z of its normal, and the height over it up to which the ground hides the sun
/// (m, negative in the light); the fourth is 0. `towardsSun` is a unit vector with y > 0.
///
/// Shadows by one sweep away from the sun: what hides it at a sample hides it at the next one lower by the sun's
/// slope, or the sample itself does.
std::vector<glm::vec4> makeGroundLight(const HeightField& field, glm::vec3 towardsSun);

}  // namespace windloom
