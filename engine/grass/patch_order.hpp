#pragma once
// Blades in patches of one size: compact, in Morton order, and each patch in an order in which any first part covers
// it.

#include <vector>

#include "engine/core/thread_pool.hpp"
#include "shaders/shared/bezier_blade.h"

namespace windloom {

using shared::BezierBlade;
using shared::BezierPatch;

/// However forces move it, a blade stays in the half space above its root's plane and within this many heights of its
/// root (eq. 9 to 13 keep the tip within 1.0 and the curve's middle within 0.75; the rest is for rounding and for what
/// is drawn around the curve).
inline constexpr float kBladeReach = 1.15f;

/// Adds the blades to `ordered`, patch by patch, filled up with blades of height 0, and their patches to `patches`.
/// `surface`: as BezierPatch has it; the ground's order (-1) leaves heights aside, so that hills don't tear it.
void appendPatches(const std::vector<BezierBlade>& blades, int surface, ThreadPool& pool,
                   std::vector<BezierBlade>& ordered, std::vector<BezierPatch>& patches);

/// The box that these blades stay in.
BezierPatch patchAround(const BezierBlade* blades, std::size_t count, int surface);

}  // namespace windloom
