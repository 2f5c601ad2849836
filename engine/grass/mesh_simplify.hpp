#pragma once
// Smaller versions of plant meshes for the distance. Pure arithmetic.

#include "engine/model/plant_mesh.hpp"

namespace windloom {

/// A version with at most `triangles` (>= 4) of them, about as large in the picture. A mesh of many separate pieces
/// (leaves, cards) keeps some of them, grown to the same area (Cook, Halstead, Planck & Ryu, "Stochastic Simplification
/// of Aggregate Detail", 2007); one of few pieces has its vertices merged on a grid. Bounds and alpha cutoff stay; the
/// texture is not copied.
PlantMesh simplified(const PlantMesh& mesh, std::size_t triangles);

}  // namespace windloom
