#pragma once
// Grass of Bezier blades with a memory each, on the ground and on surfaces: Jahrmann & Wimmer, "Responsive real-time
// grass rendering", 2017. Blades are placed on the processor beside the frame (bezier_placement.hpp), moved by
// BezierPhysics, culled and drawn here.
//
// Passes of a frame: bezier_patches and bezier_list list the patches in sight, near ones first. Large blades, and the
// highest of the others, are culled (bezier_cull) and drawn first; what they hide, with the hills and solids before
// them, is left out when the rest is culled and drawn: the paper's test against an earlier depth buffer, but against
// this frame's. No result is waited for.

#include <array>
#include <memory>

#include "engine/core/result.hpp"
#include "engine/gpu/buffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "engine/grass/bezier_lanes.hpp"
#include "engine/grass/bezier_physics.hpp"
#include "engine/grass/bezier_placement.hpp"
#include "engine/grass/bezier_view.hpp"
#include "engine/grass/made_beside.hpp"
#include "shaders/shared/bezier_block.h"

namespace windloom {

/// How the Bezier grass of a frame is drawn; see FrameInput.
struct BezierFrame {
  float detail = 1.0f;   ///< part of the blades of each patch, 0..1
  bool thinning = true;  ///< false: blades are neither thinned by distance nor by their size
  bool culling = true;   ///< false: nothing is left out, not even what is out of sight
  BezierCulling tests;
  GrassView view = GrassView::Normal;
  bool quick = false;  ///< simpler light, for a software renderer
};

class BezierGrass {
 public:
  /// Fails with Machine.
  static Result<BezierGrass> create(gpu::ShaderLibrary& shaders);

  /// Takes over what blades grow on and how; costs nothing while that stays the same. With `Later` the blades of before
  /// are kept until the new ones are placed. Fails with Machine where the GPU has no memory: the grass stays as it was.
  Status configure(const Project& project, Placement placement);
  [[nodiscard]] bool placing() const { return m_job != nullptr; }

  /// Fills the settings for this frame. Fails with Machine, and then nothing is drawn.
  Status bindSettings(const Project& project, const BezierFrame& frame);

  /// Finds the patches in sight. The frame block, grass settings and occluders must be bound.
  void findSeen();
  /// For the physics, after findSeen(). Empty (0 patches) where nothing grows.
  [[nodiscard]] BezierStore store() const;
  /// Changes whenever other blades are in the store.
  [[nodiscard]] int generation() const { return m_generation; }

  enum class Round { First, Rest };
  /// Tests the blades of a round and makes those that pass ready. Wind, noise, ground, solid and occluder textures,
  /// colliders and maps must be bound (render_bindings.h). `Rest` is tested against `depth`, that of the target in
  /// which the first round was drawn, multisampled or not.
  void cull(Round round, const gpu::Texture& depth);
  /// Draws what cull() found into the target of `state`.
  void draw(Round round, const gpu::PassState& state);

  /// Of a recent finished frame.
  const BezierCounts& counts();

 private:
  struct Strip {
    gpu::Buffer indices;
    gpu::VertexArray array;
    gpu::Program* program = nullptr;
    gpu::Program* plain = nullptr;
  };
  BezierGrass() = default;
  Status adopt(const Result<BezierMeadow>& placed);
  Status makePrograms();
  Status makeStrips();
  bool reduceDepth(const gpu::Texture& depth);

  std::shared_ptr<MadeBeside<BezierMeadow>> m_job;  // being placed; null: none
  Project m_placed;                                 // what the blades in the store grow on
  bool m_any = false;                               // there was one
  gpu::Program *m_patchCull = nullptr, *m_patchList = nullptr, *m_nextRound = nullptr;
  BezierLanes m_cull;
  gpu::ShaderLibrary* m_shaders = nullptr;
  std::array<Strip, BEZIER_LISTS> m_strips;
  gpu::Buffer m_settings, m_blades, m_states, m_patches, m_seen, m_lists, m_drawn, m_commands, m_start;
  gpu::Texture m_nearDepth;
  gpu::ReadbackRing m_read;
  std::uint32_t m_patchCount = 0, m_room = 0, m_kept = BEZIER_PATCH;
  long long m_bladeCount = 0;
  int m_generation = 0;
  bool m_plain = false, m_wireframe = false, m_hides = false;
  BezierCounts m_counts;
};

}  // namespace windloom
