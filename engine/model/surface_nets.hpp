#pragma once
// Triangle meshes of implicit surfaces.

#include <functional>

#include "engine/model/plant_mesh.hpp"

namespace windloom {

/// Distance-like: negative inside, positive outside, smooth near 0.
using ImplicitField = std::function<double(glm::dvec3)>;

/// The surface field = 0 in the box low..high, cut into cubes of side `cell` (all in m); it must not reach the box's
/// sides. Vertices lie on the surface to about a thousandth of a cell, normals are the field's gradient and point
/// outwards. Closed, without zero-area triangles. No bounds and no file are set.
PlantMesh meshOfField(const ImplicitField& field, glm::dvec3 low, glm::dvec3 high, double cell);

}  // namespace windloom
