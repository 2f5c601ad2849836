#pragma once
// How Bezier blades move: recovery, gravity, wind, collision and what keeps a blade its length, one invocation a blade.
// Jahrmann & Wimmer, "Responsive real-time grass rendering", 2017, section 5; shaders/shared/bezier_physics.h has the
// equations and how they are integrated.
//
// Beyond the paper: a motion is the same at any frame rate; patches that are not seen, and that nothing moves through,
// sleep, and catch up when they are seen again; after a jump in time blades stand as if time had run there. Passes:
// bezier_wake lists the patches to be stepped, bezier_step, dispatched by that list, steps them. No result is waited
// for.
//
// Drawing reads the states and nothing else, with bezierValid (bezier_pose.h), after a barrier for storage buffers.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/gpu/buffer.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/grass/bezier_lanes.hpp"
#include "engine/grass/touch_clock.hpp"
#include "engine/model/project.hpp"
#include "shaders/shared/bezier_physics.h"
#include "shaders/shared/collider.h"

namespace windloom {

using shared::BezierMover;
using shared::BezierPhysicsBlock;
using shared::BezierRun;
using shared::ColliderPrimitive;

/// Blades in GPU memory, made by BezierGrass. All outlive the calls they are given to.
struct BezierStore {
  const gpu::Buffer* blades = nullptr;   ///< BezierBlade
  const gpu::Buffer* states = nullptr;   ///< BezierState, the physics' own to fill
  const gpu::Buffer* patches = nullptr;  ///< BezierPatch
  const gpu::Buffer* seen = nullptr;     ///< begins with a uint for each patch: not 0 where it is seen this frame
  std::uint32_t patchCount = 0;
  std::uint32_t kept = 256;  ///< blades of each patch that are shown, the first ones
};

/// A step is done in parts of at most this.
inline constexpr float kBezierStepS = BEZIER_STEP_S;

/// The settings as the passes read them, for a frame at `seconds`.
BezierPhysicsBlock makeBezierPhysicsBlock(const Project& project, double seconds);

/// What moves in a step: primitives of its begin and end, where their number is the same; else those of the end stand.
/// Moving ones come first.
std::vector<BezierMover> bezierMovers(std::span<const ColliderPrimitive> begin, std::span<const ColliderPrimitive> end);
/// Parts of a step of `seconds` where something moves through, 1..BEZIER_PARTS_MOST: of BEZIER_TOUCH_STEP_S, and
/// shorter ones where a mover would go much farther than it is thick.
float bezierTouchParts(std::span<const BezierMover> movers, float seconds);

class BezierPhysics {
 public:
  /// Fails with Machine.
  static Result<BezierPhysics> create(gpu::ShaderLibrary& shaders);

  /// A new store: all its blades forget what moved them. Fails with Machine.
  Status configure(const BezierStore& store);

  /// Leads all blades to `seconds` of simulated time: from where they stand where that is shortly before, else from
  /// rest, so that they stand in the present wind, bent by what the colliders did shortly before. The same happens
  /// where time stands and what moves the blades was edited. `quick`: on a software renderer a jump in time takes fewer
  /// steps. The frame block, wind, rotors, noise and ground must be bound.
  void advance(const Project& project, const BezierStore& store, double seconds, bool quick);

  /// As a jump in time, with the next call: where the wind at the same time is another one.
  void forget() { m_clock.forget(); }

 private:
  BezierPhysics() = default;
  struct Step {
    float seconds = 0;
    bool jumped = false;
    bool looksOn = true;  ///< patches that are seen are stepped, too
  };
  void step(const BezierStore& store, const Step& step, std::span<const BezierMover> movers);
  std::span<const BezierMover> upload(std::span<const BezierMover> movers);
  bool edited(const Project& project);

  gpu::Program* m_wake = nullptr;
  BezierLanes m_step, m_stepTouched;
  gpu::Buffer m_block, m_clocks, m_list, m_commands, m_movers;
  TouchClock m_clock;
  Project m_project;  // of the last call
  bool m_warned = false;
};

}  // namespace windloom
