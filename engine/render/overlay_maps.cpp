#include "engine/render/overlay_maps.hpp"

#include <epoxy/gl.h>

#include <algorithm>

#include "engine/core/log.hpp"
#include "engine/gpu/debug_group.hpp"
#include "engine/render/render_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

// Quads a side of the mesh: under a metre each for a whole field of 100 m, which follows the ground closely. A quick
// picture takes wider ones: on llvmpipe with two cores the fine mesh alone costs 6 ms.
constexpr int kFullColumns = 112, kQuickColumns = 48;
// Pixels of the picture that one of the small picture covers, each way. Streaks want to be a few pixels wide anyway.
constexpr int kFullStreakGrain = 2, kQuickStreakGrain = 3, kQuickGrain = 2;

/// 0: at once in full.
int grainOf(GroundMap map, OverlayDetail detail) {
  if (map == GroundMap::Lic) return detail == OverlayDetail::Full ? kFullStreakGrain : kQuickStreakGrain;
  return detail == OverlayDetail::Full ? 0 : kQuickGrain;
}

}  // namespace

bool MapPass::Key::operator==(const Key& other) const {
  return map == other.map && wind == other.wind && grid.minCorner == other.grid.minCorner &&
         grid.size == other.grid.size && grid.resolution == other.grid.resolution && time == other.time &&
         camera == other.camera && size == other.size && target == other.target && ranges == other.ranges &&
         field == other.field && ambient == other.ambient && obstacles == other.obstacles && ground == other.ground;
}

Result<MapPass> MapPass::create(gpu::ShaderLibrary& shaders) {
  MapPass pass;
  if (Status loaded = loadPrograms(shaders, {{"field/speed map", &pass.m_speed},
                                             {"field/divergence map", &pass.m_divergence},
                                             {"field/vorticity map", &pass.m_vorticity},
                                             {"field/lic", &pass.m_lic},
                                             {"field/map picture", &pass.m_picture}});
      !loaded) {
    return loaded.error();
  }
  return pass;
}

const gpu::Program& MapPass::program(GroundMap map) const {
  if (map == GroundMap::Divergence) return *m_divergence;
  if (map == GroundMap::Vorticity) return *m_vorticity;
  return map == GroundMap::Lic ? *m_lic : *m_speed;
}

bool MapPass::fitTarget(glm::ivec2 size) {
  if (m_target.size() == size) return true;
  m_target = {};
  m_key = {};
  Result<gpu::Framebuffer> made = gpu::Framebuffer::create("ground map", size, {.colour = GL_RGBA8});
  if (!made) {
    logError(made.error().text());
    return false;
  }
  m_target = std::move(*made);
  return true;
}

/// Where the target still shows the same, it rests.
bool MapPass::drawSmall(const FrameInput& input, const GroundArea& area, int grain, int columns) {
  const glm::ivec2 size = glm::max((input.size + grain - 1) / grain, glm::ivec2(1));
  if (!fitTarget(size)) return false;
  const Project& project = *input.project;
  const Overlays& overlays = input.overlays;
  Key key{overlays.map,
          input.wind.name,
          input.wind.grid,
          input.time,
          input.camera,
          input.size,
          size,
          {overlays.speedRange, overlays.divergenceRange, overlays.vorticityRange},
          project.field,
          project.ambient,
          project.obstacles,
          project.terrain->heights};
  if (key == m_key) return true;
  m_key = std::move(key);
  const gpu::DebugGroup group("small ground map");
  gpu::apply({.framebuffer = m_target.name(), .viewport = {0, 0, size.x, size.y}, .depth = gpu::Depth::TestAndWrite});
  m_target.clearColour(glm::vec4(0.0f));
  m_target.clearDepth(1.0f);
  drawMesh(program(overlays.map), area, {}, columns);
  return true;
}

void MapPass::draw(const FrameInput& input, gpu::PassState state, OverlayLift lift, OverlayDetail detail) {
  const Overlays& overlays = input.overlays;
  const GroundArea area =
      seenArea(input.camera, input.size, *input.project->field, input.project->terrain->heights.get());
  if (overlays.map == GroundMap::None || area.empty()) return;
  const int grain = grainOf(overlays.map, detail);
  m_divergence->set("range", std::max(overlays.divergenceRange, 1e-6f));
  m_vorticity->set("range", std::max(overlays.vorticityRange, 1e-6f));
  m_lic->set("grain", static_cast<float>(grain));
  const int columns = detail == OverlayDetail::Full ? kFullColumns : kQuickColumns;
  if (grain > 0 && !drawSmall(input, area, grain, columns)) return;
  if (grain > 0) m_target.colour().bind(RENDER_TEXTURE_MAP);
  state.depth = gpu::Depth::Test;
  gpu::apply(state);
  drawMesh(grain > 0 ? *m_picture : program(overlays.map), area, lift, columns);
}

void MapPass::drawMesh(const gpu::Program& program, const GroundArea& area, OverlayLift lift, int columns) {
  program.use();
  program.set("area", glm::vec4(area.low, area.high - area.low));
  program.set("columns", columns);
  program.set("lift", lift.vec());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 2 * (columns + 1), columns);
}

}  // namespace windloom
