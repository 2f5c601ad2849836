#include "engine/render/overlay_maps.hpp"

#include <epoxy/gl.h>

#include <algorithm>

#include "engine/core/log.hpp"
#include "engine/gpu/debug_group.hpp"
#include "engine/render/render_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

// Quads a side of the mesh: under a metre each for a whole field of 100 m, which follows the ground closely enough.
constexpr int kColumns = 112;

}  // namespace

bool MapPass::StreakKey::operator==(const StreakKey& other) const {
  return wind == other.wind && grid.minCorner == other.grid.minCorner && grid.size == other.grid.size &&
         grid.resolution == other.grid.resolution && time == other.time && camera == other.camera &&
         size == other.size && target == other.target && range == other.range && field == other.field &&
         ambient == other.ambient && obstacles == other.obstacles;
}

Result<MapPass> MapPass::create(gpu::ShaderLibrary& shaders) {
  MapPass pass;
  if (Status loaded = loadPrograms(shaders, {{"field/speed map", &pass.m_speed},
                                             {"field/divergence map", &pass.m_divergence},
                                             {"field/vorticity map", &pass.m_vorticity},
                                             {"field/lic", &pass.m_streaks},
                                             {"field/lic map", &pass.m_lic}});
      !loaded) {
    return loaded.error();
  }
  return pass;
}

void MapPass::prepare(const FrameInput& input, int grain) {
  if (input.overlays.map != GroundMap::Lic) return;
  const glm::ivec2 target = glm::max((input.size + grain - 1) / grain, glm::ivec2(1));
  if (m_streakTarget.size() != target) {
    m_streakTarget = {};
    m_key = {};
    Result<gpu::Framebuffer> made = gpu::Framebuffer::create("streaks", target, {.colour = GL_R8});
    if (!made) {
      logError(made.error().text());
      return;
    }
    m_streakTarget = std::move(*made);
  }
  const Project& project = *input.project;
  StreakKey key{input.wind.name, input.wind.grid,           input.time,    input.camera,    input.size,
                target,          input.overlays.speedRange, project.field, project.ambient, project.obstacles};
  if (key == m_key) return;
  m_key = std::move(key);
  const gpu::DebugGroup group("streaks");
  gpu::apply({.framebuffer = m_streakTarget.name(),
              .viewport = {0, 0, target.x, target.y},
              .depth = gpu::Depth::TestAndWrite});
  m_streakTarget.clearColour(glm::vec4(0.5f));
  m_streakTarget.clearDepth(1.0f);
  m_streaks->use();
  m_streaks->set("grain", static_cast<float>(grain));
  drawMesh(*m_streaks, seenArea(input.camera, input.size, *project.field), {});
}

void MapPass::draw(const FrameInput& input, gpu::PassState state, OverlayLift lift) const {
  const GroundArea area = seenArea(input.camera, input.size, *input.project->field);
  state.depth = gpu::Depth::Test;
  gpu::apply(state);
  switch (input.overlays.map) {
    case GroundMap::None:
      return;
    case GroundMap::Speed:
      return drawMesh(*m_speed, area, lift);
    case GroundMap::Divergence:
      m_divergence->set("range", std::max(input.overlays.divergenceRange, 1e-6f));
      return drawMesh(*m_divergence, area, lift);
    case GroundMap::Vorticity:
      m_vorticity->set("range", std::max(input.overlays.vorticityRange, 1e-6f));
      return drawMesh(*m_vorticity, area, lift);
    case GroundMap::Lic:
      if (m_streakTarget.name() == 0) return;
      m_streakTarget.colour().bind(RENDER_TEXTURE_STREAKS);
      return drawMesh(*m_lic, area, lift);
  }
}

void MapPass::drawMesh(const gpu::Program& program, const GroundArea& area, OverlayLift lift) {
  if (area.empty()) return;
  program.use();
  program.set("area", glm::vec4(area.low, area.high - area.low));
  program.set("columns", kColumns);
  program.set("lift", lift.vec());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * (kColumns + 1), kColumns);
}

}  // namespace windloom
