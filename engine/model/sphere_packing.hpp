#pragma once
// A set of spheres that stands for a mesh where grass meets it.
//
// The mesh is cut into voxels, the longest side into about 40, or more where more spheres may be used. A voxel is
// inside where most of three axis-parallel rays through its centre cross the surface an odd number of times, so that
// small holes do no harm; of a mesh that encloses nothing (a sheet, an open bowl) the voxels that the surface touches
// count instead. Voxels are larger where triangles lie over each other so often that to ask them all would take too
// long. Then the largest sphere that fits around a voxel not yet covered is taken, again and again (greedy, as
// medial sphere packings begin).

#include <memory>
#include <vector>

#include "engine/model/plant_mesh.hpp"

namespace windloom {

/// Rays and points that the triangles of a mesh are asked for, together: a third of a second. Meshes that artists make
/// need a tenth; what would need more is cut into larger voxels.
inline constexpr std::size_t kMostPackingWork = 50'000'000;

/// Centre and radius, m; largest first, at most `most` (1..kMaxSpheres). Every centre is inside, no sphere sticks out
/// of the mesh by more than a voxel, and together they cover nearly all of it. Empty for a mesh without triangles.
std::vector<glm::vec4> packSpheres(const PlantMesh& mesh, std::size_t most = kUsualSpheres);

/// The mesh with at most so many spheres: itself where it was packed with as many, a copy otherwise. Null stays null.
std::shared_ptr<const PlantMesh> packedWith(std::shared_ptr<const PlantMesh> mesh, int most);

}  // namespace windloom
