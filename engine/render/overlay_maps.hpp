#pragma once
// Draws the one map that may lie on the ground: speed, divergence, vorticity or line integral convolution.

#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/render/overlay_lattice.hpp"
#include "engine/render/overlay_mark_pass.hpp"

namespace windloom {

enum class OverlayDetail { Full, Quick };  ///< Quick: where every pixel is computed by the processor

class MapPass {
 public:
  /// Fails with Machine.
  static Result<MapPass> create(gpu::ShaderLibrary& shaders);

  /// Needs frame block, wind, noise and map of solids, and an empty vertex array bound; `state` with blending. Streaks,
  /// and in quick pictures every map, are drawn at a lower resolution first, and only where wind, time, camera or
  /// settings changed.
  void draw(const FrameInput& input, gpu::PassState state, OverlayLift lift, OverlayDetail detail);

 private:
  /// All that a map drawn at a lower resolution depends on.
  struct Key {
    GroundMap map = GroundMap::None;
    unsigned wind = 0;
    GridMapping grid{};
    double time = -1;
    ViewCamera camera;
    glm::ivec2 size{0}, target{0};
    glm::vec3 ranges{0.0f};
    Shared<FieldSettings> field;
    Shared<AmbientWind> ambient;
    Shared<std::vector<Obstacle>> obstacles;
    Shared<HeightField> ground;
    bool operator==(const Key& other) const;
  };
  [[nodiscard]] const gpu::Program& program(GroundMap map) const;
  bool fitTarget(glm::ivec2 size);
  bool drawSmall(const FrameInput& input, const GroundArea& area, int grain, int columns);
  static void drawMesh(const gpu::Program& program, const GroundArea& area, OverlayLift lift, int columns);

  gpu::Program* m_speed = nullptr;
  gpu::Program* m_divergence = nullptr;
  gpu::Program* m_vorticity = nullptr;
  gpu::Program* m_lic = nullptr;
  gpu::Program* m_picture = nullptr;
  gpu::Framebuffer m_target;
  Key m_key;
};

}  // namespace windloom
