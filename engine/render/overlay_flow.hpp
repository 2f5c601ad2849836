#pragma once
// Draws wind vectors and streamlines.

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/render/overlay_lattice.hpp"
#include "engine/render/overlay_mark_pass.hpp"

namespace windloom {

class FlowPass {
 public:
  /// Fails with Machine.
  static Result<FlowPass> create(gpu::ShaderLibrary& shaders);

  /// Both need frame block, wind, noise and map of solids, and an empty vertex array bound; `state` with blending.
  void drawVectors(const FrameInput& input, gpu::PassState state, OverlayLift lift);
  void drawStreamlines(const FrameInput& input, gpu::PassState state, OverlayLift lift);

 private:
  /// Seeds of the last camera; made again when it moves.
  struct Seeds {
    gpu::Buffer buffer;
    int count = 0;
    ViewCamera camera;
    glm::ivec2 size{0};
    Shared<FieldSettings> field;
  };
  static void fit(Seeds& seeds, const FrameInput& input, float pixels);
  bool fitLines();

  gpu::Program* m_vectors = nullptr;
  gpu::Program* m_trace = nullptr;
  gpu::Program* m_lines = nullptr;
  Seeds m_vectorSeeds, m_lineSeeds;
  gpu::Buffer m_points;  // of the streamlines
};

}  // namespace windloom
