#pragma once
// What a meadow's settings mean for the chains of segments that its blades are (shaders/shared/segment_chain.h).

#include "engine/model/project.hpp"
#include "shaders/shared/segment_chain.h"

namespace windloom {

using shared::ChainBlock;
using shared::ChainLeans;
using shared::ChainState;

/// The chain of the meadow's mean blade. Springs and damping give it GrassSettings::swingRate and swingDamping; the
/// drive is such that in steady winds it leans as `arc` does, exactly so for an exponent of 1.
ChainBlock makeChainBlock(const GrassSettings& grass);

/// Time after which a blade that was let go bends less than anyone sees (1 mm at its tip), s.
float settledAfter(const GrassSettings& grass);

}  // namespace windloom
