#pragma once
// How Bezier blades move: recovery, gravity, wind, collision and what keeps a blade its length, one invocation a blade.
// Jahrmann & Wimmer, "Responsive real-time grass rendering", 2017, section 4.
//
// Beyond the paper: recovery is integrated exactly and everything in steps of at most kBezierStepS, so that a motion is
// the same at any frame rate; patches that are neither seen nor touched sleep and catch up when they are seen again.

#include <cstdint>
#include <span>

#include "engine/core/result.hpp"
#include "engine/gpu/buffer.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/model/project.hpp"
#include "shaders/shared/collider.h"

namespace windloom {

/// Blades in GPU memory, made by BezierGrass. All outlive the calls they are given to.
struct BezierStore {
  const gpu::Buffer* blades = nullptr;   ///< BezierBlade
  const gpu::Buffer* states = nullptr;   ///< BezierState, the physics' own to fill
  const gpu::Buffer* patches = nullptr;  ///< BezierPatch
  const gpu::Buffer* seen = nullptr;     ///< uint for each patch, 1: seen this frame
  std::uint32_t patchCount = 0;
  std::uint32_t kept = 256;              ///< blades of each patch that are shown, the first ones
};

inline constexpr float kBezierStepS = 1.0f / 60.0f;

class BezierPhysics {
 public:
  /// Fails with Machine.
  static Result<BezierPhysics> create(gpu::ShaderLibrary& shaders);

  /// A new store: all its blades forget what moved them. Fails with Machine.
  Status configure(const BezierStore& store);

  /// Leads all blades to `seconds` of simulated time: from where they stand where that is shortly before, else from rest,
  /// so that they stand in the present wind, bent by what the colliders did shortly before. `quick`: on a software
  /// renderer a jump in time takes fewer steps. The frame block, wind, noise, ground and what BezierWind needs must be
  /// bound.
  void advance(const Project& project, const BezierStore& store, double seconds, bool quick);

 private:
  BezierPhysics() = default;
};

}  // namespace windloom
