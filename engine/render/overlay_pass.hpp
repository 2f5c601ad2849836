#pragma once
// Draws what the artist works with over the scene: a map of the ground, wind vectors, streamlines, arrows, points,
// probes, outlines.

#include "engine/gpu/timer.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "engine/render/overlay_flow.hpp"
#include "engine/render/overlay_maps.hpp"

namespace windloom {

class OverlayPass {
 public:
  /// Fails with Machine.
  static Result<OverlayPass> create(gpu::ShaderLibrary& shaders);

  /// Draws over the scene in `framebuffer`, which holds its depth, too. Frame block, wind, noise and the map of solids
  /// must be bound. What stone or hills hide stays faintly visible of marks. A stage of `timer` for each kind.
  void draw(const FrameInput& input, unsigned framebuffer, OverlayDetail detail, gpu::GpuTimer& timer);

 private:
  OverlayPass(MarkPass marks, FlowPass flow, MapPass maps);
  MarkPass m_marks;
  FlowPass m_flow;
  MapPass m_maps;
  gpu::VertexArray m_noVertices;
};

}  // namespace windloom
