#pragma once
// The meshes of the built-in surfaces that grass grows on.

#include <memory>

#include "engine/model/project.hpp"

namespace windloom {

/// Of a built-in shape: longest side 1 m, centred in x and z, its lowest point at y = 0; closed, with smooth normals
/// that point outwards; at most kMaxPlantTriangles. The hare looks along +x. SurfaceShape::Mesh gives an empty mesh.
PlantMesh makeSurfaceMesh(SurfaceShape shape);

/// What a surface is made of: the one mesh of its built-in shape, made when first asked for (about 0.2 s for the hare),
/// or the one read from its file. Null while that hasn't been read. From any thread.
std::shared_ptr<const PlantMesh> surfaceMesh(const Surface& surface);

}  // namespace windloom
