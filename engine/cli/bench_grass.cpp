#include <epoxy/gl.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "engine/cli/bench.hpp"
#include "engine/cli/bench_project.hpp"
#include "engine/cli/bench_timing.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/render/frame_renderer.hpp"

namespace windloom::cli {
namespace {

struct Meadow {
  const char* name;
  float metres, density;
};

struct Shot {
  const char* name;
  ViewCamera camera;
};

/// Cameras over a meadow of `metres`: standing in it, looking over it, from above with all of it in sight.
std::vector<Shot> shotsOf(float metres) {
  Shot eye{"eye", {}}, over{"over", {}}, top{"top", {}};
  eye.camera.position = {0, 1.7f, 0.4f * metres};
  eye.camera.target = {0, 1.2f, 0};
  over.camera.position = {0, 0.25f * metres, 0.65f * metres};
  top.camera.position = {0, 1.3f * metres, 0};
  top.camera.up = {0, 0, -1};
  for (Shot* shot : {&eye, &over, &top}) shot->camera.farPlane = std::max(2000.0f, 4.0f * metres);
  return {eye, over, top};
}

/// Whirls of 25 m with up to 8 m/s, standing in for a solved wind so that only the grass is measured.
Result<gpu::Texture> whirls(const GridMapping& grid) {
  Result<gpu::Texture> texture = gpu::Texture::create2D("bench wind", grid.resolution, GL_RG32F);
  if (!texture) return texture;
  std::vector<glm::vec2> cells;
  const float wave = 2.0f * std::numbers::pi_v<float> / 25.0f;
  for (int k = 0; k < grid.resolution.y; ++k) {
    for (int i = 0; i < grid.resolution.x; ++i) {
      const glm::vec2 at = cellCentreToWorld(glm::vec2(i, k), grid.minCorner, grid.cellSize) * wave;
      cells.push_back(8.0f * glm::vec2(std::sin(at.x) * std::cos(at.y), -std::cos(at.x) * std::sin(at.y)));
    }
  }
  texture->upload(GL_RG, GL_FLOAT, cells.data());
  return texture;
}

struct GrassBench {
  const BenchSetup& setup;
  FrameRenderer& renderer;
  const gpu::Framebuffer& target;
  std::vector<BenchRow> rows;

  Status add(const Meadow& meadow) {
    const Project project = benchMeadow(meadow.metres, meadow.density);
    const FieldSettings& field = *project.field;
    const GridMapping grid = makeGridMapping(field.centre, field.size, field.resolution);
    const Result<gpu::Texture> wind = whirls(grid);
    if (!wind) return wind.error();
    for (const Shot& shot : shotsOf(meadow.metres)) addShot(meadow, shot, project, {wind->name(), grid});
    return Done{};
  }

  void addShot(const Meadow& meadow, const Shot& shot, const Project& project, const WindTexture& wind) {
    FrameInput input;
    input.project = &project;
    input.wind = wind;
    input.camera = shot.camera;
    input.size = target.size();
    input.framebuffer = target.name();
    input.overlays.arrows = false;
    std::vector<double> wall;
    FrameStats stats;
    const Measured gpu = measure({3, 5, 40, setup.capSeconds}, [&] {
      double ms = 0;
      wall.push_back(wallMs([&] { ms = gpuMs([&] { stats = renderer.render(input); }); }));
      input.time += 1.0 / 60.0;
      return ms;
    });
    BenchRow row = {{"blades", meadow.name},   {"camera", shot.name},        {"gpu ms", gpu.median},
                    {"wall ms", median(wall)}, {"drawn", stats.bladesDrawn}, {"runs", gpu.runs}};
    row["stages"] = Json::object();
    for (const auto& [pass, ms] : stats.passMs) row["stages"][pass] = ms;
    rows.push_back(std::move(row));
  }
};

}  // namespace

Result<std::vector<BenchRow>> benchGrass(const BenchSetup& setup) {
  if (setup.context == nullptr) return std::vector<BenchRow>{};
  const bool quick = setup.size == BenchSize::Quick;
  const Result<std::unique_ptr<FrameRenderer>> renderer = FrameRenderer::create(*setup.context, *setup.shaders);
  if (!renderer) return renderer.error();
  gpu::FramebufferOptions options;
  options.colour = GL_RGBA8;
  const Result<gpu::Framebuffer> target =
      gpu::Framebuffer::create("bench picture", quick ? glm::ivec2(160, 90) : glm::ivec2(1920, 1080), options);
  if (!target) return target.error();
  std::vector<Meadow> meadows = {{"1 M", 100, 100}, {"7 M", 100, 700}};
  // A hundred million take minutes on a software renderer and say nothing there.
  if (!setup.context->info().software) meadows.push_back({"100 M", 1000, 100});
  if (quick) meadows = {{"2 k", 10, 20}};
  GrassBench bench{setup, **renderer, *target, {}};
  for (const Meadow& meadow : meadows) {
    if (Status added = bench.add(meadow); !added) return added.error();
  }
  return std::move(bench.rows);
}

}  // namespace windloom::cli
