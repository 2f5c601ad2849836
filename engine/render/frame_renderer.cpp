#include "engine/render/frame_renderer.hpp"

#include <epoxy/gl.h>

#include "engine/core/log.hpp"
#include "engine/gpu/context.hpp"
#include "engine/gpu/timer.hpp"
#include "engine/grass/bezier_grass.hpp"
#include "engine/grass/grass_maps.hpp"
#include "engine/grass/instanced_grass.hpp"
#include "engine/grass/plant_pass.hpp"
#include "engine/grass/rotors.hpp"
#include "engine/grass/shell_grass.hpp"
#include "engine/render/backdrop.hpp"
#include "engine/render/collider_pass.hpp"
#include "engine/render/frame_block.hpp"
#include "engine/render/grass_dynamics.hpp"
#include "engine/render/ground_pass.hpp"
#include "engine/render/noise_texture.hpp"
#include "engine/render/occluders.hpp"
#include "engine/render/overlay_pass.hpp"
#include "engine/render/scene_targets.hpp"
#include "engine/render/solids.hpp"
#include "engine/render/surface_pass.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

// Below this detail a software renderer draws one sample a pixel and a simpler ground: there the time goes
// further in blades.
constexpr float kSoftwareFullDetail = 0.6f;
// Hills and solids as the culling sees them: a texel is 4 to 8 pixels wide.
constexpr glm::ivec2 kOccluderSize{256, 128};

struct Parts {
  InstancedGrass grass;
  BezierGrass bezier;
  BezierPhysics bezierPhysics;
  ShellGrass shell;
  GrassMaps maps;
  PlantPass plants;
  GrassDynamics dynamics;
  Backdrop backdrop;
  GroundPass ground;
  SolidPass solids;
  ColliderPass colliders;
  SurfacePass surfaces;
  Occluders occluders;
  OverlayPass overlays;
  Rotors rotors;
  gpu::Texture noise;
  gpu::Buffer frame;
};

Result<Parts> createParts(gpu::ShaderLibrary& shaders) {
  Result<InstancedGrass> grass = InstancedGrass::create(shaders);
  if (!grass) return grass.error();
  Result<BezierGrass> bezier = BezierGrass::create(shaders);
  if (!bezier) return bezier.error();
  Result<BezierPhysics> bezierPhysics = BezierPhysics::create(shaders);
  if (!bezierPhysics) return bezierPhysics.error();
  Result<ShellGrass> shell = ShellGrass::create(shaders);
  if (!shell) return shell.error();
  Result<GrassMaps> maps = GrassMaps::create();
  if (!maps) return maps.error();
  Result<PlantPass> plants = PlantPass::create(shaders);
  if (!plants) return plants.error();
  Result<GrassDynamics> dynamics = GrassDynamics::create(shaders);
  if (!dynamics) return dynamics.error();
  Result<Backdrop> backdrop = Backdrop::create(shaders);
  if (!backdrop) return backdrop.error();
  Result<GroundPass> ground = GroundPass::create(shaders);
  if (!ground) return ground.error();
  Result<SolidPass> solids = SolidPass::create(shaders);
  if (!solids) return solids.error();
  Result<ColliderPass> colliders = ColliderPass::create(shaders);
  if (!colliders) return colliders.error();
  Result<SurfacePass> surfaces = SurfacePass::create(shaders);
  if (!surfaces) return surfaces.error();
  Result<OverlayPass> overlays = OverlayPass::create(shaders);
  if (!overlays) return overlays.error();
  Result<Occluders> occluders = Occluders::create(shaders, kOccluderSize);
  if (!occluders) return occluders.error();
  Result<Rotors> rotors = Rotors::create();
  if (!rotors) return rotors.error();
  Result<gpu::Texture> noise = createNoiseTexture();
  if (!noise) return noise.error();
  Result<gpu::Buffer> frame = gpu::Buffer::create("frame", sizeof(FrameBlock), gpu::BufferUse::Dynamic);
  if (!frame) return frame.error();
  return Parts{std::move(*grass),     std::move(*bezier),   std::move(*bezierPhysics), std::move(*shell),
               std::move(*maps),      std::move(*plants),   std::move(*dynamics),      std::move(*backdrop),
               std::move(*ground),    std::move(*solids),   std::move(*colliders),     std::move(*surfaces),
               std::move(*occluders), std::move(*overlays), std::move(*rotors),        std::move(*noise),
               std::move(*frame)};
}

/// Lets the wind be read between cell centres whatever the texture's own filter, and leaves no sampler bound.
class WindSampler {
 public:
  WindSampler() {
    GLuint name = 0;
    glCreateSamplers(1, &name);
    m_name = name;
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  ~WindSampler() { glDeleteSamplers(1, &m_name); }
  WindSampler(const WindSampler&) = delete;
  WindSampler& operator=(const WindSampler&) = delete;

  void bind() const { glBindSampler(RENDER_TEXTURE_WIND, m_name); }
  static void unbind() { glBindSampler(RENDER_TEXTURE_WIND, 0); }

 private:
  GLuint m_name = 0;
};

class FrameRendererImpl final : public FrameRenderer {
 public:
  FrameRendererImpl(Parts parts, bool software) : m_parts(std::move(parts)), m_software(software) {}

  FrameStats render(const FrameInput& input) override {
    WL_REQUIRE(input.project != nullptr, "a frame shows a project");
    if (input.size.x <= 0 || input.size.y <= 0) return stats();
    if (!adoptProject(input) || !fitTargets(input)) return stats();
    m_timer.beginFrame();
    bindFrame(input);
    m_timer.stage("occluders");
    updateOccluders(input);
    moveGrass(input);
    m_timer.stage("grass cull");
    m_parts.grass.prepare();
    m_parts.plants.prepare(plantView(input));
    drawScene(input);
    if (input.overlays.any()) {
      const auto detail = quick(input) ? OverlayDetail::Quick : OverlayDetail::Full;
      m_parts.overlays.draw(input, m_targets.scene(), detail, m_timer);
    }
    m_timer.stage("resolve");
    m_targets.resolve(input.framebuffer, input.origin);
    m_timer.endFrame();
    WindSampler::unbind();
    return stats();
  }

  void advance(const FrameInput& input) override {
    WL_REQUIRE(input.project != nullptr, "a frame shows a project");
    if (!adoptProject(input)) return;
    bindFrame(input);
    moveGrass(input);
    WindSampler::unbind();
  }

 private:
  /// Passes take over the parts that changed. A part the machine refuses is logged once and the frame skipped.
  bool adoptProject(const FrameInput& input) {
    const Project& project = *input.project;
    const Shared<HeightField>& heights = project.terrain->heights;
    const bool ground = heights != m_heights;
    if (ground && !accept(m_parts.ground.configure(heights, defaultLight().sunDirection))) return false;
    if (ground || project.field != m_field || project.grass != m_grass) {
      if (!accept(m_parts.grass.configure(*project.field, *project.grass, heights.get()))) return false;
      if (!accept(m_parts.dynamics.configure(project, m_parts.grass.layout()))) return false;
    }
    if (project.grass != m_grass && !accept(m_parts.maps.configure(*project.grass))) return false;
    if (project.field != m_field || project.grass != m_grass || project.species != m_species) {
      if (!accept(m_parts.plants.configure(*project.field, *project.grass, *project.species))) return false;
    }
    if (ground || project.field != m_field || project.obstacles != m_obstacles) {
      if (!accept(m_parts.solids.configure(*project.obstacles, *project.field, heights.get()))) return false;
    }
    if (project.colliders != m_colliders && !accept(m_parts.colliders.configure(*project.colliders))) return false;
    if (ground || project.surfaces != m_surfaces) {
      if (!accept(m_parts.surfaces.configure(*project.surfaces, heights.get()))) return false;
    }
    const Placement placement = input.quality.complete ? Placement::Wait : Placement::Later;
    if (isBezier(project) && !accept(m_parts.bezier.configure(project, placement))) return false;
    if (isShell(project) && !accept(m_parts.shell.configure(project, placement))) return false;
    m_heights = heights;
    m_field = project.field;
    m_grass = project.grass;
    m_species = project.species;
    m_obstacles = project.obstacles;
    m_colliders = project.colliders;
    m_surfaces = project.surfaces;
    return true;
  }

  static bool isBezier(const Project& project) { return project.grass->kind == GrassKind::Bezier; }
  static bool isShell(const Project& project) { return project.grass->kind == GrassKind::Shell; }
  /// What else than the instanced grass stands on the ground.
  static InstancedGrass::Blades bladesOf(const Project& project, bool thinning) {
    using Blades = InstancedGrass::Blades;
    const bool fades = thinning && project.shell->method == ShellMethod::Filled;
    if (isShell(project)) return fades ? Blades::Shells : Blades::None;
    return isBezier(project) ? Blades::None : Blades::Drawn;
  }

  bool accept(const Status& status) {
    if (status) return true;
    const std::string text = status.error().text();
    if (text != m_lastError) logError(text);
    m_lastError = text;
    return false;
  }

  [[nodiscard]] bool quick(const FrameInput& input) const {
    return m_software && input.quality.detail < kSoftwareFullDetail && !input.quality.still;
  }

  [[nodiscard]] Backdrop::GroundDetail groundDetail(const FrameInput& input) const {
    if (!quick(input)) return Backdrop::GroundDetail::Full;
    const GrassSettings& grass = *input.project->grass;
    const bool maps = grass.densityPixels || grass.heightPixels || grass.colourPixels;
    const bool plain = !maps && input.project->colliders->empty();
    return plain ? Backdrop::GroundDetail::Plain : Backdrop::GroundDetail::Quick;
  }

  bool fitTargets(const FrameInput& input) {
    const int samples = input.quality.samples > 0 ? input.quality.samples : quick(input) ? 1 : 4;
    if (m_targets.size() == input.size && m_targets.samples() == samples) return true;
    m_targets = SceneTargets();
    Result<SceneTargets> targets = SceneTargets::create(input.size, samples);
    if (!targets) return accept(targets.error());
    m_targets = std::move(*targets);
    return true;
  }

  void bindFrame(const FrameInput& input) {
    m_block = makeFrameBlock(input, defaultLight());
    m_parts.frame.write(&m_block, sizeof m_block);
    m_parts.frame.bindUniform(RENDER_UBO_FRAME);
    const Project& project = *input.project;
    const bool inertial = project.grass->deformation == Deformation::Inertial;
    const bool remembers = inertial || !project.colliders->empty() || m_parts.dynamics.touched();
    const auto chains = remembers ? InstancedGrass::Chains::Some : InstancedGrass::Chains::None;
    const GrassQuality quality{input.quality.detail, input.quality.thinning, input.quality.culling, quick(input)};
    accept(m_parts.grass.bindSettings(*project.grass, *project.species, quality, m_block,
                                      occluding() ? m_parts.occluders.levels() : 0, chains,
                                      bladesOf(project, input.quality.thinning)));
    if (isBezier(project)) accept(m_parts.bezier.bindSettings(project, bezierFrame(input)));
    m_parts.maps.bind();
    m_parts.noise.bind(RENDER_TEXTURE_NOISE);
    m_parts.ground.bind();
    m_parts.solids.updateMap();
    m_parts.solids.bindMap();
    m_parts.colliders.bindShades(*input.project, input.time, input.camera.position, defaultLight().sunDirection,
                                 m_parts.surfaces.shades());
    m_parts.rotors.bind(*project.rotors, input.time);
    m_parts.backdrop.bakeSky();
    // The wind may come from compute shaders of the solver: they write it as an image or storage buffer.
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    glBindTextureUnit(RENDER_TEXTURE_WIND, input.wind.name != 0 ? input.wind.name : m_parts.noise.name());
    m_windSampler.bind();
  }

  [[nodiscard]] PlantView plantView(const FrameInput& input) const {
    return {.eye = glm::vec3(m_block.cameraPosition),
            .orthographic = m_block.cameraPosition.w > 0.5f,
            .pixelScale = m_block.pixelScale.x,
            .detail = input.quality.detail,
            .thinning = input.quality.thinning,
            .culling = input.quality.culling};
  }

  [[nodiscard]] BezierFrame bezierFrame(const FrameInput& input) const {
    return {.detail = input.quality.detail,
            .thinning = input.quality.thinning,
            .culling = input.quality.culling,
            .tests = input.bezierCulling,
            .view = input.grassView,
            .quick = quick(input)};
  }

  [[nodiscard]] bool occluding() const {
    return m_parts.solids.any() || m_parts.surfaces.any() || !m_parts.ground.flat();
  }

  void updateOccluders(const FrameInput& input) {
    if (!occluding() || isShell(*input.project)) {  // shells are not culled by it
      m_parts.occluders.bind();
      return;
    }
    m_parts.occluders.update([&](const gpu::PassState& state) {
      m_parts.solids.draw(state);
      m_parts.surfaces.draw(state);
      if (!m_parts.ground.flat()) m_parts.ground.draw(state, m_block, input.camera, Backdrop::GroundDetail::Plain);
    });
  }

  void moveGrass(const FrameInput& input) {
    if (isShell(*input.project)) {
      m_timer.stage("grass tiles");
      const ShellFrame frame{input.quality.detail, input.quality.thinning, m_targets.samples(), quick(input)};
      accept(m_parts.shell.prepare(*input.project, frame, m_block));
      m_parts.dynamics.bind();  // for the plants
      return;
    }
    if (isBezier(*input.project)) {
      m_timer.stage("grass cull patches");
      moveBezier(input);
      return;
    }
    m_timer.stage("grass physics");
    const int most = m_software ? kMostVirtualBladesInSoftware : kMostVirtualBlades;
    if (accept(m_parts.dynamics.fitWind(*input.project->grass, input.wind.grid.resolution, most))) {
      m_parts.dynamics.advance(*input.project, input.time, quick(input) ? RunUp::Quick : RunUp::Full);
    }
    m_parts.dynamics.bind();
  }

  void moveBezier(const FrameInput& input) {
    m_parts.dynamics.bind();  // for the plants
    m_parts.bezier.findSeen();
    m_timer.stage("grass physics");
    const BezierStore store = m_parts.bezier.store();
    if (store.patchCount == 0) return;
    if (m_parts.bezier.generation() != m_bladesMoved) {
      if (!accept(m_parts.bezierPhysics.configure(store))) return;
      m_bladesMoved = m_parts.bezier.generation();
    }
    m_parts.bezierPhysics.advance(*input.project, store, input.time, quick(input));
  }

  void drawScene(const FrameInput& input) {
    const gpu::PassState state{.framebuffer = m_targets.scene(),
                               .viewport = {0, 0, input.size.x, input.size.y},
                               .depth = gpu::Depth::TestAndWrite};
    gpu::apply(state);
    m_targets.clearDepth();
    m_timer.stage("solids");
    m_parts.solids.draw(state);
    m_parts.surfaces.draw(state);
    m_parts.colliders.draw(state, *input.project, input.time);
    if (isBezier(*input.project)) {
      drawBezier(state);
    } else if (isShell(*input.project)) {
      drawShells(state);
    } else {
      m_timer.stage("grass");
      m_parts.grass.draw(state);
    }
    m_timer.stage("plants");
    m_parts.plants.draw(state);
    m_timer.stage("ground");
    const auto detail = groundDetail(input);
    if (m_parts.ground.flat()) {
      m_parts.backdrop.drawGround(state, input.camera, detail);
    } else {
      m_parts.ground.draw(state, m_block, input.camera, detail);
    }
    m_timer.stage("sky");
    m_parts.backdrop.drawSky(state);
  }

  /// Large blades first; what they hide of the others isn't drawn.
  void drawBezier(const gpu::PassState& state) {
    using Round = BezierGrass::Round;
    m_timer.stage("grass cull near");
    m_parts.bezier.cull(Round::First, m_targets.depth());
    m_timer.stage("grass near");
    m_parts.bezier.draw(Round::First, state);
    m_timer.stage("grass cull far");
    m_parts.bezier.cull(Round::Rest, m_targets.depth());
    m_timer.stage("grass far");
    m_parts.bezier.draw(Round::Rest, state);
  }

  void drawShells(const gpu::PassState& state) {
    m_timer.stage("grass shells");
    m_parts.surfaces.each([&](const Surface& surface, const glm::mat4& world, const ObjectMesh& mesh) {
      const float away = glm::length(glm::vec3(world[3]) - glm::vec3(m_block.cameraPosition));
      const int layers = m_parts.shell.useSurface(surface, world, away, state);
      if (layers > 0) mesh.draw(layers);
    });
    m_parts.shell.drawGround(state);
  }

  FrameStats stats() {
    FrameStats stats;
    if (m_grass && m_grass->kind == GrassKind::Shell) {
      stats.shell = m_parts.shell.counts();
      stats.complete = !m_parts.shell.growing();
      stats.bladesTotal = stats.bladesDrawn = m_parts.shell.blades();
    } else if (m_grass && m_grass->kind == GrassKind::Bezier) {
      stats.bezier = m_parts.bezier.counts();
      stats.complete = !m_parts.bezier.placing();
      stats.bladesTotal = stats.bezier.blades;
      stats.bladesDrawn = stats.bezier.drawn;
    } else {
      stats.bladesTotal = m_parts.grass.layout().bladesTotal;
      stats.bladesDrawn = m_parts.grass.bladesDrawn();
    }
    stats.passMs = m_timer.stages();
    stats.gpuMs = m_timer.totalMs();
    return stats;
  }

  Parts m_parts;
  bool m_software;
  WindSampler m_windSampler;
  SceneTargets m_targets;
  gpu::GpuTimer m_timer;
  FrameBlock m_block{};   // of the last frame
  int m_bladesMoved = 0;  // generation of the Bezier blades that the physics knows
  Shared<FieldSettings> m_field;
  Shared<HeightField> m_heights;
  Shared<GrassSettings> m_grass;
  Shared<std::vector<Species>> m_species;
  Shared<std::vector<Obstacle>> m_obstacles;
  Shared<std::vector<Collider>> m_colliders;
  Shared<std::vector<Surface>> m_surfaces;
  std::string m_lastError;
};

}  // namespace

Result<std::unique_ptr<FrameRenderer>> FrameRenderer::create(gpu::Context& context, gpu::ShaderLibrary& shaders) {
  Result<Parts> parts = createParts(shaders);
  if (!parts) return parts.error();
  return std::unique_ptr<FrameRenderer>(
      std::make_unique<FrameRendererImpl>(std::move(*parts), context.info().software));
}

}  // namespace windloom
