#pragma once
// What stands for a surface where it takes light from the ground and grass around it.

#include <glm/glm.hpp>
#include <vector>

#include "engine/model/plant_mesh.hpp"

namespace windloom {

/// About `count` spheres (centre and radius, m in the world) spread over the mesh, that together cover about what it
/// covers: none for a mesh without area. `world` scales evenly. The same for the same mesh; it takes some milliseconds.
std::vector<glm::vec4> surfaceShades(const PlantMesh& mesh, const glm::mat4& world, std::size_t count);

}  // namespace windloom
