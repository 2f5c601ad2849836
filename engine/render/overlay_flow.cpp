#include "engine/render/overlay_flow.hpp"

#include <epoxy/gl.h>

#include <algorithm>

#include "engine/render/buffer_room.hpp"
#include "engine/render/render_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

constexpr int kVectorVertices = 9;
constexpr float kVectorPixels = 22.0f, kLinePixels = 21.0f;  // least distance of seeds in a picture 500 pixels high

/// As pixelUnit() of shaders/include/overlay.glsl.
float pixelUnit(glm::ivec2 size) {
  return std::clamp(static_cast<float>(size.y) / 500.0f, 0.5f, 2.0f);
}

}  // namespace

Result<FlowPass> FlowPass::create(gpu::ShaderLibrary& shaders) {
  FlowPass pass;
  if (Status loaded = loadPrograms(shaders, {{"field/vectors", &pass.m_vectors},
                                             {"field/trace streamlines", &pass.m_trace},
                                             {"field/streamlines", &pass.m_lines}});
      !loaded) {
    return loaded.error();
  }
  return pass;
}

void FlowPass::fit(Seeds& seeds, const FrameInput& input, float pixels) {
  const Shared<HeightField>& ground = input.project->terrain->heights;
  if (seeds.camera == input.camera && seeds.size == input.size && seeds.field == input.project->field &&
      seeds.ground == ground)
    return;
  seeds.camera = input.camera;
  seeds.size = input.size;
  seeds.field = input.project->field;
  seeds.ground = ground;
  const std::vector<FlowSeed> made =
      makeFlowSeeds(input.camera, input.size, *seeds.field, pixels * pixelUnit(input.size), ground.get());
  seeds.count = 0;
  if (made.empty()) return;
  if (!makeRoom(seeds.buffer, "flow seeds", made.size() * sizeof(FlowSeed))) return;
  seeds.buffer.write(std::span<const FlowSeed>(made));
  seeds.count = static_cast<int>(made.size());
}

bool FlowPass::fitLines() {
  const std::size_t bytes = static_cast<std::size_t>(m_lineSeeds.count) * FLOW_LINE_POINTS * sizeof(glm::vec4);
  return bytes > 0 && makeRoom(m_points, "streamlines", bytes, gpu::BufferUse::Static);
}

void FlowPass::drawVectors(const FrameInput& input, gpu::PassState state, OverlayLift lift) {
  fit(m_vectorSeeds, input, kVectorPixels);
  if (m_vectorSeeds.count == 0) return;
  state.depth = gpu::Depth::Test;
  gpu::apply(state);
  m_vectors->use();
  m_vectors->set("lift", lift.vec());
  m_vectorSeeds.buffer.bindStorage(RENDER_SSBO_SEEDS);
  glDrawArraysInstanced(GL_TRIANGLES, 0, kVectorVertices, m_vectorSeeds.count);
}

void FlowPass::drawStreamlines(const FrameInput& input, gpu::PassState state, OverlayLift lift) {
  fit(m_lineSeeds, input, kLinePixels);
  if (!fitLines()) return;
  m_trace->use();
  m_trace->set("count", m_lineSeeds.count);
  m_lineSeeds.buffer.bindStorage(RENDER_SSBO_SEEDS);
  m_points.bindStorage(RENDER_SSBO_LINES);
  m_trace->dispatchOver({m_lineSeeds.count, 1});
  state.depth = gpu::Depth::Test;
  gpu::apply(state);
  m_lines->use();
  m_lines->set("lift", lift.vec());
  // The lines were written by field/trace streamlines.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * FLOW_LINE_POINTS, m_lineSeeds.count);
}

}  // namespace windloom
