#pragma once
// Where surfaces stand.

#include <glm/glm.hpp>

#include "engine/model/project.hpp"

namespace windloom {

/// From the mesh's own metres to the world: scaled, tilted about its x axis, turned about y (from +x towards +z), its
/// origin over `position`, and its lowest point `lift` over the ground there. `ground` may be null: flat at 0. Takes
/// time in proportion to the mesh's vertices where it is tilted. A surface that has not been read stands as if it were
/// a point.
glm::mat4 surfacePose(const Surface& surface, const HeightField* ground);

/// Of the mesh's own metres: `size` for built-in shapes, `scale` for files.
float surfaceScale(const Surface& surface);

}  // namespace windloom
