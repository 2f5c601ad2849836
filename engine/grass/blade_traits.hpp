#pragma once
// What single Bezier blades are like: height, width, stiffness, direction and colour, shared a bit within clumps and
// tufts.

#include "engine/grass/growth_area.hpp"
#include "engine/model/project.hpp"
#include "shaders/shared/bezier_blade.h"

namespace windloom {

using shared::BezierBlade;

/// The means and ranges of the blades of one area.
struct BladeTraits {
  float height = 0.5f, heightVariation = 0, width = 0.02f;  ///< m; part of the height
  float stiffness = 1, stiffnessVariation = 0;
  float clumping = 0.5f, dryness = 0, dandelions = 0;  ///< 0..1
  float clumpSizeM = 0.75f;
  bool level = true;  ///< clumps are cells of the ground rather than of space
  std::uint32_t form = BEZIER_FORM_QUAD, seed = 0;
};

/// The ground's blades, before `most` lowers their number; or a surface's.
BladeTraits groundTraits(const GrassSettings& grass, const BezierSettings& bezier);
BladeTraits surfaceTraits(const GrassSettings& grass, const BezierSettings& bezier, const Surface& surface);

/// Where in a tuft a blade stands.
struct TuftPlace {
  std::uint32_t hash = 0;    ///< of the tuft
  glm::vec3 outwards{0.0f};  ///< unit vector at right angles to the blade's up, roughly
  float part = 0;            ///< from its middle to its rim, 0..1
};

/// `tuft`: null for a single blade.
BezierBlade makeBlade(const BladeTraits& traits, const GrowthPoint& point, std::uint32_t seed, const TuftPlace* tuft);

/// `direction` of a blade (0..1) whose front points along `front`, as far as that is at right angles to `up`.
float turnTowards(glm::vec3 up, glm::vec3 front);

/// Parts of a blade's record.
glm::vec3 upOf(const BezierBlade& blade);
glm::vec2 sizesOf(const BezierBlade& blade);  ///< height, width, m

}  // namespace windloom
