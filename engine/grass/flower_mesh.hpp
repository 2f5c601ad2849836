#pragma once
// The built-in flowers as meshes. Pure arithmetic.
//
// A built-in flower is one unit high; its widths are to scale for a plant of Species::height. It has no texture: uv.x
// says how much of a petal a vertex is (0 stem and leaf, 1 petal), uv.y how freely it flutters.

#include "engine/model/project.hpp"

namespace windloom {

/// Near: 60 to 200 triangles. Far: 6 to 20, the same outline and mean colours. `shape` must be Daisy, Poppy or Spike.
struct FlowerMesh {
  PlantMesh near, far;
};
FlowerMesh makeFlower(const Species& species);

}  // namespace windloom
