#pragma once
// Draws the one map that may lie on the ground: speed, divergence, vorticity or line integral convolution.

#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/render/overlay_lattice.hpp"
#include "engine/render/overlay_mark_pass.hpp"

namespace windloom {

class MapPass {
 public:
  /// Fails with Machine.
  static Result<MapPass> create(gpu::ShaderLibrary& shaders);

  /// What must come before the scene's targets are drawn on: the streaks of the line integral convolution, for every
  /// `grain` pixels of the picture one, and only where wind, time or camera changed.
  void prepare(const FrameInput& input, int grain);

  /// Needs frame block, wind, noise and map of solids, and an empty vertex array bound; `state` with blending.
  void draw(const FrameInput& input, gpu::PassState state, OverlayLift lift) const;

 private:
  /// All that the streaks depend on.
  struct StreakKey {
    unsigned wind = 0;
    GridMapping grid{};
    double time = -1;
    ViewCamera camera;
    glm::ivec2 size{0}, target{0};
    float range = 0;
    Shared<FieldSettings> field;
    Shared<AmbientWind> ambient;
    Shared<std::vector<Obstacle>> obstacles;
    bool operator==(const StreakKey& other) const;
  };
  static void drawMesh(const gpu::Program& program, const GroundArea& area, OverlayLift lift);

  gpu::Program* m_speed = nullptr;
  gpu::Program* m_divergence = nullptr;
  gpu::Program* m_vorticity = nullptr;
  gpu::Program* m_streaks = nullptr;
  gpu::Program* m_lic = nullptr;
  gpu::Framebuffer m_streakTarget;
  StreakKey m_key;
};

}  // namespace windloom
