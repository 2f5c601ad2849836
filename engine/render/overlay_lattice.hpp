#pragma once
// Where streamlines and wind vectors stand: places that stay where they are in the world while the camera moves,
// about equally dense everywhere in the picture.

#include <vector>

#include "engine/model/project.hpp"
#include "engine/render/view_camera.hpp"
#include "shaders/shared/flow_seed.h"

namespace windloom {

using shared::FlowSeed;

/// The ground rectangle that holds all of the field that the camera sees; size 0 where it sees none of it.
struct GroundArea {
  glm::vec2 low{0.0f}, high{0.0f};  ///< m
  [[nodiscard]] bool empty() const { return low.x >= high.x || low.y >= high.y; }
};
GroundArea seenArea(const ViewCamera& camera, glm::ivec2 size, const FieldSettings& field);

/// Seeds in the picture, on square lattices of 2^k m: each lattice where it measures `pixels` to 2.5 x `pixels` in
/// the picture, blended at both ends of that range, so that nothing appears or goes at once. Same camera, same seeds.
std::vector<FlowSeed> makeFlowSeeds(const ViewCamera& camera, glm::ivec2 size, const FieldSettings& field,
                                    float pixels);

}  // namespace windloom
