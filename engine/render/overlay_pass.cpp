#include "engine/render/overlay_pass.hpp"

#include <epoxy/gl.h>

#include "engine/core/log.hpp"
#include "engine/gpu/debug_group.hpp"
#include "engine/render/render_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

constexpr float kHiddenAlpha = 0.38f;   // of marks behind grass and stone
constexpr int kArrowVertices = 27;      // as in shaders/field/arrow.vert
constexpr int kPointVertices = 12;      // disc and mast
constexpr int kOutlineVertices = 66;    // strip of 32 sectors
constexpr int kVectorVertices = 9;

}  // namespace

Result<OverlayPass> OverlayPass::create(gpu::ShaderLibrary& shaders) {
  OverlayPass pass;
  if (Status loaded = loadPrograms(shaders, {{"field/arrow", &pass.m_arrow},
                                             {"field/area", &pass.m_area},
                                             {"field/point", &pass.m_point},
                                             {"field/outline", &pass.m_outline},
                                             {"field/vectors", &pass.m_vectors},
                                             {"field/speed map", &pass.m_speed}});
      !loaded) {
    return loaded.error();
  }
  pass.m_noVertices = gpu::VertexArray::create("overlay");
  return pass;
}

void OverlayPass::upload(std::string_view label, const std::vector<OverlayMark>& marks, Marks& to) {
  to.count = 0;
  if (marks.empty()) return;
  const std::size_t bytes = marks.size() * sizeof(OverlayMark);
  if (to.buffer.bytes() < bytes) {
    Result<gpu::Buffer> buffer = gpu::Buffer::create(label, bytes + bytes / 2, gpu::BufferUse::Dynamic);
    if (!buffer) {
      logError(buffer.error().text());
      return;
    }
    to.buffer = std::move(*buffer);
  }
  to.buffer.write(marks.data(), bytes);
  to.count = marks.size();
}

void OverlayPass::draw(const FrameInput& input, unsigned framebuffer) {
  const gpu::DebugGroup group("overlays");
  m_noVertices.bind();
  const float tips = 0.8f * input.project->grass->height;
  gpu::PassState state{.framebuffer = framebuffer, .viewport = {0, 0, input.size.x, input.size.y}, .blend = gpu::Blend::Premultiplied};
  if (input.overlays.speed) drawSpeed(state, 0.5f * tips);
  if (input.overlays.vectors) drawVectors(input, state, tips);
  if (!input.overlays.arrows) return;
  const OverlayMarks marks = makeOverlayMarks(*input.project, input.graph, input.time, input.overlays.speedRange, input.highlight);
  upload("arrow marks", marks.arrows, m_arrows);
  upload("point marks", marks.points, m_points);
  upload("outline marks", marks.outlines, m_outlines);
  if (m_arrows.count > 0) {
    gpu::apply(state);
    m_area->use();
    m_area->set("height", tips);
    m_arrows.buffer.bindStorage(RENDER_SSBO_MARKS);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(m_arrows.count));
  }
  state.depth = gpu::Depth::Test;
  state.compare = gpu::DepthCompare::Greater;
  drawMarks(state, tips, kHiddenAlpha);
  state.compare = gpu::DepthCompare::LessEqual;
  drawMarks(state, tips, 1.0f);
}

void OverlayPass::drawSpeed(const gpu::PassState& state, float height) const {
  gpu::apply(state);
  m_speed->use();
  m_speed->set("height", height);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void OverlayPass::drawVectors(const FrameInput& input, const gpu::PassState& state, float height) const {
  const VectorLattice lattice = makeVectorLattice(input.camera, input.size, *input.project->field);
  const int count = lattice.nodes.x * lattice.nodes.y;
  if (count <= 0) return;
  m_vectors->use();
  m_vectors->set("lattice", glm::vec4(lattice.first, lattice.spacing, height));
  m_vectors->set("columns", lattice.nodes.x);
  gpu::PassState pass = state;
  pass.depth = gpu::Depth::Test;
  for (const auto& [compare, visible] : {std::pair{gpu::DepthCompare::Greater, kHiddenAlpha}, {gpu::DepthCompare::LessEqual, 1.0f}}) {
    pass.compare = compare;
    gpu::apply(pass);
    m_vectors->set("visible", visible);
    glDrawArraysInstanced(GL_TRIANGLES, 0, kVectorVertices, count);
  }
}

void OverlayPass::drawMarks(const gpu::PassState& state, float height, float visible) const {
  const auto drawSet = [&](const gpu::Program& program, const Marks& marks, GLenum mode, int vertices) {
    if (marks.count == 0) return;
    program.use();
    program.set("height", height);
    program.set("visible", visible);
    marks.buffer.bindStorage(RENDER_SSBO_MARKS);
    glDrawArraysInstanced(mode, 0, vertices, static_cast<GLsizei>(marks.count));
  };
  gpu::apply(state);
  drawSet(*m_outline, m_outlines, GL_TRIANGLE_STRIP, kOutlineVertices);
  gpu::PassState solid = state;
  solid.cull = gpu::Cull::Back;
  gpu::apply(solid);
  drawSet(*m_arrow, m_arrows, GL_TRIANGLES, kArrowVertices);
  gpu::apply(state);
  drawSet(*m_point, m_points, GL_TRIANGLES, kPointVertices);
}

}  // namespace windloom
