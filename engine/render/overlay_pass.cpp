#include "engine/render/overlay_pass.hpp"

#include "engine/gpu/debug_group.hpp"

namespace windloom {
namespace {

constexpr float kLeadHeights = 1.5f;  // of the grass height
constexpr float kLeastLead = 0.25f;   // m

const char* stageOf(GroundMap map) {
  switch (map) {
    case GroundMap::Speed:
      return "overlay speed";
    case GroundMap::Divergence:
      return "overlay divergence";
    case GroundMap::Vorticity:
      return "overlay vorticity";
    case GroundMap::Lic:
      return "overlay lic";
    case GroundMap::None:
      break;
  }
  return "overlay map";
}

}  // namespace

OverlayPass::OverlayPass(MarkPass marks, FlowPass flow, MapPass maps)
    : m_marks(std::move(marks)),
      m_flow(std::move(flow)),
      m_maps(std::move(maps)),
      m_noVertices(gpu::VertexArray::create("overlay")) {}

Result<OverlayPass> OverlayPass::create(gpu::ShaderLibrary& shaders) {
  Result<MarkPass> marks = MarkPass::create(shaders);
  if (!marks) return marks.error();
  Result<FlowPass> flow = FlowPass::create(shaders);
  if (!flow) return flow.error();
  Result<MapPass> maps = MapPass::create(shaders);
  if (!maps) return maps.error();
  return OverlayPass(std::move(*marks), std::move(*flow), std::move(*maps));
}

void OverlayPass::draw(const FrameInput& input, unsigned framebuffer, OverlayDetail detail, gpu::GpuTimer& timer) {
  const gpu::DebugGroup group("overlays");
  const Overlays& overlays = input.overlays;
  m_noVertices.bind();
  const GrassSettings& grass = *input.project->grass;
  const OverlayLift lift{markHeight(grass), std::max(kLeadHeights * grass.height, kLeastLead)};
  const gpu::PassState state{
      .framebuffer = framebuffer, .viewport = {0, 0, input.size.x, input.size.y}, .blend = gpu::Blend::Premultiplied};
  if (overlays.map != GroundMap::None) {
    timer.stage(stageOf(overlays.map));
    m_maps.draw(input, state, lift, detail);
  }
  if (overlays.streamlines) {
    timer.stage("overlay streamlines");
    m_flow.drawStreamlines(input, state, lift);
  }
  if (overlays.vectors) {
    timer.stage("overlay vectors");
    m_flow.drawVectors(input, state, lift);
  }
  if (overlays.arrows) {
    timer.stage("overlay arrows");
    m_marks.draw(input, state, lift);
  }
}

}  // namespace windloom
