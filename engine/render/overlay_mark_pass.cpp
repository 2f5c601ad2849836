#include "engine/render/overlay_mark_pass.hpp"

#include <epoxy/gl.h>

#include <algorithm>

#include "engine/core/log.hpp"
#include "engine/render/render_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

constexpr float kHiddenAlpha = 0.38f;  // of marks behind stone and hills
constexpr int kSegmentVertices = 12;   // as in shaders/field/arrow.vert
constexpr int kHeadVertices = 12;
constexpr int kPointVertices = 12;              // disc and mast
constexpr int kOutlineVertices = 66;            // strip of 32 sectors
constexpr std::size_t kMostSegments = 30'000;  // of all arrows together; one alone has kSegments
constexpr std::size_t kSegments = 24;
// Above so many arrows what lies behind stone and hills isn't drawn: 10,000 would cost twice as much, and the picture is
// full of them anyway.
constexpr std::size_t kMostHidden = 3000;
constexpr float kSeamPixels = 1.3f, kSeamOnMapPixels = 2.2f, kMarkedSeamPixels = 2.8f;

template <class T>
void uploadTo(std::string_view label, std::span<const T> values, gpu::Buffer& buffer, std::size_t& count) {
  count = 0;
  if (values.empty()) return;
  if (buffer.bytes() < values.size_bytes()) {
    const std::size_t bytes = values.size_bytes() + values.size_bytes() / 2;
    Result<gpu::Buffer> made = gpu::Buffer::create(label, bytes, gpu::BufferUse::Dynamic);
    if (!made) {
      logError(made.error().text());
      return;
    }
    buffer = std::move(*made);
  }
  buffer.write(values);
  count = values.size();
}

/// One on flat ground. Fewer for each arrow where there are many: then none is long in the picture.
int segmentsOf(std::size_t arrows, bool flat) {
  if (flat) return 1;
  return static_cast<int>(std::clamp<std::size_t>(kMostSegments / std::max<std::size_t>(arrows, 1), 1, kSegments));
}

}  // namespace

Result<MarkPass> MarkPass::create(gpu::ShaderLibrary& shaders) {
  MarkPass pass;
  if (Status loaded = loadPrograms(shaders, {{"field/arrow", &pass.m_arrow},
                                             {"field/area", &pass.m_area},
                                             {"field/point", &pass.m_point},
                                             {"field/outline", &pass.m_outline}});
      !loaded) {
    return loaded.error();
  }
  return pass;
}

void MarkPass::upload(const FrameInput& input) {
  const MarkCache::Change change = m_cache.update(input);
  const OverlayMarks& marks = m_cache.marks();
  if (change.marks) {
    uploadTo("arrow marks", std::span<const OverlayMark>(marks.arrows), m_arrows.buffer, m_arrows.count);
    uploadTo("point marks", std::span<const OverlayMark>(marks.points), m_points.buffer, m_points.count);
    uploadTo("outline marks", std::span<const OverlayMark>(marks.outlines), m_outlines.buffer, m_outlines.count);
  }
  if (change.levels) uploadTo("signal levels", m_cache.signals().levels(), m_levels.buffer, m_levels.count);
}

void MarkPass::draw(const FrameInput& input, gpu::PassState state, OverlayLift lift) {
  upload(input);
  m_onMap = input.overlays.map != GroundMap::None;
  m_segments = segmentsOf(m_arrows.count, input.project->terrain->heights == nullptr);
  m_arrow->set("onMap", m_onMap ? 1.0f : 0.0f);
  if (m_levels.count > 0) m_levels.buffer.bindStorage(RENDER_SSBO_LEVELS);
  state.depth = gpu::Depth::Test;
  drawAreas(state, lift);
  for (const auto& [compare, visible] :
       {std::pair{gpu::DepthCompare::Greater, kHiddenAlpha}, {gpu::DepthCompare::LessEqual, 1.0f}}) {
    if (compare == gpu::DepthCompare::Greater && m_arrows.count > kMostHidden) continue;
    state.compare = compare;
    gpu::apply(state);
    drawSet(*m_outline, m_outlines, lift, GL_TRIANGLE_STRIP, kOutlineVertices, visible);
    drawArrows(state, lift, visible);
    gpu::apply(state);
    drawSet(*m_point, m_points, lift, GL_TRIANGLES, kPointVertices, visible);
  }
}

void MarkPass::drawAreas(gpu::PassState state, OverlayLift lift) const {
  state.compare = gpu::DepthCompare::LessEqual;
  gpu::apply(state);
  m_area->use();
  m_area->set("segments", m_segments);
  drawSet(*m_area, m_arrows, lift, GL_TRIANGLES, 6 * m_segments * std::max(m_segments / 3, 1), 1.0f);
}

void MarkPass::drawArrows(const gpu::PassState& state, OverlayLift lift, float visible) const {
  gpu::PassState solid = state;
  solid.cull = gpu::Cull::Back;
  gpu::apply(solid);
  const int vertices = kSegmentVertices * m_segments + kHeadVertices;
  m_arrow->use();
  m_arrow->set("segments", m_segments);
  // All seams before all arrows: where arrows meet, none cuts through another.
  for (const float seam : {m_onMap ? kSeamOnMapPixels : kSeamPixels, 0.0f}) {
    m_arrow->set("seam", seam);
    m_arrow->set("markedSeam", kMarkedSeamPixels);
    drawSet(*m_arrow, m_arrows, lift, GL_TRIANGLES, vertices, visible);
  }
}

void MarkPass::drawSet(const gpu::Program& program, const Marks& marks, OverlayLift lift, unsigned mode, int vertices,
                       float visible) const {
  if (marks.count == 0) return;
  program.use();
  program.set("lift", lift.vec());
  program.set("visible", visible);
  marks.buffer.bindStorage(RENDER_SSBO_MARKS);
  glDrawArraysInstanced(mode, 0, vertices, static_cast<GLsizei>(marks.count));
}

}  // namespace windloom
