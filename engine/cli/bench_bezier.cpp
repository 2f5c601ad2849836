// Tables 1 to 3 of Jahrmann & Wimmer, "Responsive real-time grass rendering", 2017, for our samples: what a frame costs
// with everything, without collision and without culling of blades; and what culling does to the picture.
#include <epoxy/gl.h>

#include <algorithm>

#include "engine/cli/bench_frames.hpp"
#include "engine/cli/bench_project.hpp"
#include "engine/gpu/memory.hpp"
#include "engine/model/collider_motion.hpp"
#include "engine/render/framing.hpp"
#include "shaders/shared/bezier_blade.h"
#include "shaders/shared/bezier_block.h"

namespace windloom::cli {
namespace {

constexpr glm::ivec2 kPaperSize{1024, 768};
constexpr int kPaperSamples = 8;
constexpr double kMoment = 4.0;  // s: gusts are on their way, balls have left trails
constexpr int kSettlingFrames = 4;
constexpr const char* kScenes[] = {"nature", "helicopter"};
constexpr BezierCulling kNoTests{false, false, false, false};

struct Mode {
  const char* name;
  bool collision;
  BezierCulling culling;
};
constexpr Mode kModes[] = {{"all features", true, {}}, {"no collision", false, {}}, {"no culling", true, kNoTests}};

struct Column {
  FrameTimes times;
  std::size_t spheres = 0;  // that blades collide with

  /// Of the stages whose names begin so, ms.
  [[nodiscard]] double stages(std::string_view prefix) const {
    double sum = 0;
    for (const auto& [stage, ms] : times.stages.items()) {
      if (stage.starts_with(prefix)) sum += ms.get<double>();
    }
    return sum;
  }
  [[nodiscard]] double visibility() const { return stages("occluders") + stages("grass cull"); }
  [[nodiscard]] double rendering() const { return stages("grass") - stages("grass cull") - stages("grass physics"); }
  [[nodiscard]] double rest() const { return stages("") - stages("grass") - stages("occluders"); }
  [[nodiscard]] double perBlade(std::size_t bytes) const {
    return static_cast<double>(bytes) / static_cast<double>(std::max(times.bezier.blades, 1LL));
  }
  /// Bytes moved, each once, where all blades of the patches in sight are stepped, tested and drawn from a record.
  [[nodiscard]] double movedMB() const {
    constexpr double kShape = sizeof(shared::BezierBlade), kState = sizeof(shared::BezierState), kEntry = 4;
    constexpr double kStep = kShape + 2 * kState, kTest = kShape + kState,
                     kDraw = 2 * (sizeof(shared::BezierDrawn) + kEntry);
    const BezierCounts& counts = times.bezier;
    return (static_cast<double>(counts.patches) * sizeof(shared::BezierPatch) +
            static_cast<double>(counts.inPatches) * (kStep + kTest) + static_cast<double>(counts.drawn) * kDraw) /
           1e6;
  }
};

struct Line {
  const char* what;
  Json (*of)(const Column& column);
};
constexpr Line kLines[] = {
    {"frame ms", [](const Column& c) -> Json { return c.times.frameMs; }},
    {"wind ms", [](const Column& c) -> Json { return c.times.windMs; }},
    {"physics ms", [](const Column& c) -> Json { return c.stages("grass physics"); }},
    {"visibility ms", [](const Column& c) -> Json { return c.visibility(); }},
    {"rendering ms", [](const Column& c) -> Json { return c.rendering(); }},
    {"rest ms", [](const Column& c) -> Json { return c.rest(); }},
    {"blades", [](const Column& c) -> Json { return c.times.bezier.blades; }},
    {"blades drawn", [](const Column& c) -> Json { return c.times.bezier.drawn; }},
    {"blades of visible patches", [](const Column& c) -> Json { return c.times.bezier.inPatches; }},
    {"culled by orientation", [](const Column& c) -> Json { return c.times.bezier.orientation; }},
    {"culled by frustum", [](const Column& c) -> Json { return c.times.bezier.frustum; }},
    {"culled by distance", [](const Column& c) -> Json { return c.times.bezier.distance; }},
    {"culled by occlusion", [](const Column& c) -> Json { return c.times.bezier.occlusion; }},
    {"collision spheres", [](const Column& c) -> Json { return c.spheres; }},
    {"bytes a blade, shape", [](const Column& c) -> Json { return c.perBlade(c.times.shapeBytes); }},
    {"bytes a blade, state", [](const Column& c) -> Json { return c.perBlade(c.times.stateBytes); }},
    {"floor: MB moved", [](const Column& c) -> Json { return c.movedMB(); }},
};

Result<Project> sampleProject(const std::string& name, BenchSize size) {
  Result<Project> project = benchSample(name);
  if (!project || size == BenchSize::Full) return project;
  FieldSettings field = *project->field;
  field.resolution = {32, 32};
  project->field = std::make_shared<FieldSettings>(field);
  BezierSettings bezier = *project->bezier;
  bezier.most = 4000;
  project->bezier = std::make_shared<BezierSettings>(bezier);
  std::vector<Collider> balls = *project->colliders;
  std::erase_if(balls, [](const Collider& collider) { return collider.shape == ColliderShape::Mesh; });
  project->colliders = std::make_shared<std::vector<Collider>>(std::move(balls));
  project->cameras = std::make_shared<std::vector<Camera>>(1, project->cameras->front());
  return project;
}

Project withoutCollision(const Project& project) {
  std::vector<Collider> colliders = *project.colliders;
  for (Collider& collider : colliders) collider.muted = true;
  Project muted = project;
  muted.colliders = std::make_shared<std::vector<Collider>>(std::move(colliders));
  return muted;
}

struct BezierBench {
  const BenchSetup& setup;
  glm::ivec2 size;
  std::vector<BenchRow> rows;

  Result<Column> measured(const Project& project, const ViewCamera& camera, const BezierCulling& culling) {
    const Result<std::unique_ptr<Simulation>> wind = benchWind(setup, project);
    if (!wind) return wind.error();
    Result<FrameBench> frames = FrameBench::create(setup, size);
    if (!frames) return frames.error();
    Result<FrameTimes> times = frames->run(project, wind->get(), camera, {.samples = kPaperSamples}, culling);
    if (!times) return times.error();
    return Column{std::move(*times), colliderPrimitives(project, kMoment).size()};
  }

  Status addTimes(const std::string& scene, const Project& project) {
    std::vector<Column> columns;
    const ViewCamera camera = viewThrough(project.cameras->front());
    for (const Mode& mode : kModes) {
      Result<Column> column = measured(mode.collision ? project : withoutCollision(project), camera, mode.culling);
      if (!column) return column.error();
      columns.push_back(std::move(*column));
    }
    for (const Line& line : kLines) {
      BenchRow row = {{"scene", scene}, {"what", line.what}};
      for (std::size_t i = 0; i < columns.size(); ++i) row[kModes[i].name] = line.of(columns[i]);
      row["runs"] = columns.front().times.frames;
      rows.push_back(std::move(row));
    }
    BenchRow& first = rows[rows.size() - std::size(kLines)];
    for (std::size_t i = 0; i < columns.size(); ++i) first["stages"][kModes[i].name] = columns[i].times.stages;
    return Done{};
  }

  /// Pictures of one moment from all cameras, culled and whole.
  Status addPictures(const std::string& scene, const Project& project) {
    const Result<std::unique_ptr<Simulation>> wind = benchWind(setup, project);
    if (!wind) return wind.error();
    (*wind)->runTo(setup.size == BenchSize::Quick ? 0.1 : kMoment);
    Result<std::unique_ptr<FrameRenderer>> renderer = FrameRenderer::create(*setup.context, *setup.shaders);
    if (!renderer) return renderer.error();
    const Result<gpu::Framebuffer> target = benchTarget(size);
    if (!target) return target.error();
    const WindTexture texture{(*wind)->solver().velocityTexture(), (*wind)->solver().grid()};
    for (const Camera& camera : *project.cameras) {
      FrameInput input = benchFrame(project, texture, viewThrough(camera), *target);
      input.time = (*wind)->time();
      if (Status added = addPicture(scene, camera.name, **renderer, input, *target); !added) return added;
    }
    return Done{};
  }

  Status addPicture(const std::string& scene, const std::string& camera, FrameRenderer& renderer, FrameInput input,
                    const gpu::Framebuffer& target) {
    const auto shoot = [&](const FrameQuality& quality, const BezierCulling& tests) -> FrameStats {
      input.quality = quality;
      input.bezierCulling = tests;
      target.clearColour({1.0f, 0.0f, 1.0f, 0.0f});
      FrameStats stats;
      // Counts come with a later frame.
      for (int i = 0; i < kSettlingFrames; ++i) {
        stats = renderer.render(input);
        glFinish();
      }
      return stats;
    };
    const FrameStats culled = shoot({.samples = kPaperSamples}, {});
    if (target.readRgba8()[3] == 0) return makeError(ErrorKind::Machine, "the picture wasn't drawn (see the log)");
    const FloatImage seen = halfLuma(target);
    const FrameStats whole = shoot({.thinning = false, .culling = false, .samples = kPaperSamples}, kNoTests);
    const double ssim = meanSsim(seen, halfLuma(target));
    const long long visible = std::max(culled.bezier.inPatches, 1LL);
    const auto add = [&](const std::string& what, const Json& all, const Json& none) {
      rows.push_back({{"scene", scene},
                      {"what", camera + ": " + what},
                      {kModes[0].name, all},
                      {kModes[2].name, none},
                      {"runs", 1}});
    };
    add("SSIM to no culling", ssim, nullptr);
    add("blades drawn", culled.bezier.drawn, whole.bezier.drawn);
    add("drawn of visible patches %", 100.0 * static_cast<double>(culled.bezier.drawn) / static_cast<double>(visible),
        nullptr);
    return Done{};
  }
};

}  // namespace

Result<std::vector<BenchRow>> benchBezier(const BenchSetup& setup) {
  if (setup.context == nullptr) return std::vector<BenchRow>{};
  glm::ivec2 size = setup.picture.value_or(setup.size == BenchSize::Quick ? glm::ivec2(160, 120) : kPaperSize);
  size = glm::max(size - size % 2, glm::ivec2(32));  // halved to compare
  BezierBench bench{setup, size, {}};
  for (const char* scene : kScenes) {
    const Result<Project> project = sampleProject(scene, setup.size);
    if (!project) return project.error();
    if (Status added = bench.addTimes(scene, *project); !added) return added.error();
    if (Status added = bench.addPictures(scene, *project); !added) return added.error();
  }
  return std::move(bench.rows);
}

}  // namespace windloom::cli
