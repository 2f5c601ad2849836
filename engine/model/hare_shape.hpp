#pragma once
// A sitting hare as an implicit surface, of our own making: blended ellipsoids and tapered limbs.

#include <glm/glm.hpp>

namespace windloom {

/// Negative inside, about the distance near the surface. The hare looks along +x, sits on y = 0, is symmetric in z and
/// about 1 high with its ears.
double hareField(glm::dvec3 place);

}  // namespace windloom
