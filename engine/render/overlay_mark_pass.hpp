#pragma once
// Draws arrows with their areas, points, probes and the outlines of obstacles.

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/render/overlay_marks.hpp"

namespace windloom {

/// Where marks lie: m over the ground, and m by which their depth leads, so that blades don't hide them.
struct OverlayLift {
  float height = 0.0f, lead = 0.0f;
  [[nodiscard]] glm::vec2 vec() const { return {height, lead}; }
};

class MarkPass {
 public:
  /// Fails with Machine.
  static Result<MarkPass> create(gpu::ShaderLibrary& shaders);

  /// Needs the frame block and an empty vertex array bound; `state` with blending. What stone hides stays faintly
  /// visible.
  void draw(const FrameInput& input, gpu::PassState state, OverlayLift lift);

 private:
  struct Marks {
    gpu::Buffer buffer;
    std::size_t count = 0;
  };
  void upload(const FrameInput& input);
  void drawAreas(gpu::PassState state, OverlayLift lift) const;
  void drawArrows(const gpu::PassState& state, OverlayLift lift, float visible) const;
  void drawSet(const gpu::Program& program, const Marks& marks, OverlayLift lift, unsigned mode, int vertices,
               float visible) const;

  gpu::Program* m_arrow = nullptr;
  gpu::Program* m_area = nullptr;
  gpu::Program* m_point = nullptr;
  gpu::Program* m_outline = nullptr;
  MarkCache m_cache;
  bool m_onMap = false;
  int m_segments = 1;  // of each arrow
  Marks m_arrows, m_points, m_outlines, m_levels;
};

}  // namespace windloom
