#pragma once
// Cameras for pictures.

#include "engine/model/project.hpp"
#include "engine/render/view_camera.hpp"

namespace windloom {

ViewCamera viewThrough(const Camera& camera);

/// Shows the whole field in a 16:9 picture from a hill to its south (+Z), against the light. `ground` null: flat.
ViewCamera frameField(const FieldSettings& field, const HeightField* ground = nullptr);

/// Straight down on the whole field, orthographic, -Z up in the picture.
ViewCamera frameFieldFromAbove(const FieldSettings& field, const HeightField* ground = nullptr);

}  // namespace windloom
