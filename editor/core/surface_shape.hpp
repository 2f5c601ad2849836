#pragma once
// Where surfaces and rotors stand as tools see them: outlines on the ground, extents, bodies. 2D positions are (x, z)
// in metres.

#include <array>
#include <vector>

#include "editor/core/ground.hpp"
#include "engine/model/project.hpp"

namespace windloom::editor {

/// Around a surface, in its own axes: turned with it, not tilted; y from its lowest point. A mesh that has not been
/// read counts as a cube of 1 m.
struct SurfaceBox {
  glm::vec3 low{0.0f}, high{0.0f};  ///< m from its position
};
SurfaceBox boxOf(const Surface& surface);

/// From a surface's own axes to the world.
glm::vec2 toWorld(const Surface& surface, glm::vec2 own);
/// Corners of its box seen from above.
std::vector<glm::vec2> outlineOf(const Surface& surface);
bool isInside(const Surface& surface, glm::vec2 world);
/// No part of it is farther from its position seen from above, m.
float reachOf(const Surface& surface);

/// The corners of its box in the world: four below, then the four above them, in the order of outlineOf.
std::array<glm::vec3, 8> cornersOf(const Surface& surface, const Ground& ground);
/// Whether the ray meets its box.
bool meets(const Surface& surface, const Ground& ground, const Ray& ray);

/// Places around a rotor's disc, at its height.
std::vector<glm::vec3> ringOf(const Rotor& rotor, const Ground& ground);
/// The middle of that disc.
glm::vec3 hubOf(const Rotor& rotor, const Ground& ground);

}  // namespace windloom::editor
