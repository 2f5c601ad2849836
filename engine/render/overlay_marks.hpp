#pragma once
// The overlay's marks from a project: pure, on the CPU, when the project or what is marked changes.

#include <vector>

#include "engine/render/frame_renderer.hpp"
#include "shaders/shared/overlay_mark.h"

namespace windloom {

using shared::OverlayMark;

struct OverlayMarks {
  std::vector<OverlayMark> arrows;
  std::vector<OverlayMark> points;  ///< and probes
  std::vector<OverlayMark> outlines;
};

/// Hidden things are left out; arrows need both their points. `graph` (may be null) gives the factors at
/// `time`, else they are 1.
OverlayMarks makeOverlayMarks(const Project& project, const GraphEvaluator* graph, double time, float speedRange,
                              const Highlight& highlight);

/// A lattice of wind vectors that stands still in the world while the camera moves.
struct VectorLattice {
  glm::vec2 first{0.0f};  ///< m
  float spacing = 1.0f;   ///< m
  glm::ivec2 nodes{0};
};

/// About 40 nodes along the longer visible side of the field, on multiples of a power of two of a metre.
/// No nodes where none of the field is seen.
VectorLattice makeVectorLattice(const ViewCamera& camera, glm::ivec2 size, const FieldSettings& field);

}  // namespace windloom
