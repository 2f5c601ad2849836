#pragma once
// Draws what the artist works with over the scene: speed map, wind vectors, arrows, points, probes, outlines.

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "engine/render/overlay_marks.hpp"

namespace windloom {

class OverlayPass {
 public:
  /// Fails with Machine.
  static Result<OverlayPass> create(gpu::ShaderLibrary& shaders);

  /// Whether these overlays draw anything.
  static bool wanted(const Overlays& overlays) { return overlays.arrows || overlays.vectors || overlays.speed; }

  /// Draws over the scene in `framebuffer`, which holds its depth, too. Frame block, wind and noise
  /// must be bound. What grass or stone hides stays faintly visible.
  void draw(const FrameInput& input, unsigned framebuffer);

 private:
  OverlayPass() = default;
  struct Marks {
    gpu::Buffer buffer;
    std::size_t count = 0;
  };
  static void upload(std::string_view label, const std::vector<OverlayMark>& marks, Marks& to);
  void drawSpeed(const gpu::PassState& state, float height) const;
  void drawVectors(const FrameInput& input, const gpu::PassState& state, float height) const;
  void drawMarks(const gpu::PassState& state, float height, float visible) const;

  gpu::Program* m_arrow = nullptr;
  gpu::Program* m_area = nullptr;
  gpu::Program* m_point = nullptr;
  gpu::Program* m_outline = nullptr;
  gpu::Program* m_vectors = nullptr;
  gpu::Program* m_speed = nullptr;
  gpu::VertexArray m_noVertices;
  Marks m_arrows, m_points, m_outlines;
};

}  // namespace windloom
