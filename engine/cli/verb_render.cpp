#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "engine/cli/bezier_options.hpp"
#include "engine/cli/common.hpp"
#include "engine/cli/interrupt.hpp"
#include "engine/cli/option_checks.hpp"
#include "engine/cli/option_limits.hpp"
#include "engine/cli/output_path.hpp"
#include "engine/cli/program_help.hpp"
#include "engine/cli/progress.hpp"
#include "engine/cli/project_option.hpp"
#include "engine/cli/verbs.hpp"
#include "engine/cli/wind_context.hpp"
#include "engine/cli/words.hpp"
#include "engine/core/text.hpp"
#include "engine/gpu/context.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/memory_failure.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/io/image.hpp"
#include "engine/model/parameters.hpp"
#include "engine/model/validate.hpp"
#include "engine/render/framing.hpp"
#include "engine/session/session.hpp"

namespace windloom::cli {
namespace {

constexpr double kSlice = 0.25;  // s of simulated time between looks at Ctrl+C

struct Options : CommonOptions, ProjectOptions {
  std::string file, out, camera, grass, deformation, solver;
  std::string size = "1280x720", resolution;
  std::vector<std::string> overlays;
  double time = 0, fps = 30, detail = 1;
  std::optional<double> density;
  int frames = 1;
  bool fullQuality = false, everyBlade = false;
  BezierOptions bezier;
};

Error usage(const std::string& message) {
  return makeError(ErrorKind::Usage, message);
}

Result<ViewCamera> cameraOf(const Options& options, const Project& project) {
  const std::vector<Camera>& cameras = *project.cameras;
  if (options.camera.empty())
    return cameras.empty() ? frameField(*project.field, project.terrain->heights.get()) : viewThrough(cameras.front());
  std::string names = "above";
  for (const Camera& camera : cameras) {
    if (camera.name == options.camera) return viewThrough(camera);
    names += ", " + camera.name;
  }
  if (options.camera == "above") return frameFieldFromAbove(*project.field, project.terrain->heights.get());
  return usage("--camera: found '" + options.camera + "', expected one of " + names);
}

Json shellCountsJson(const ShellCounts& counts) {
  return {{"nearShells", counts.nearShells},
          {"tiles", counts.tiles},
          {"layers", counts.layers},
          {"skippedLayers", counts.skippedLayers},
          {"error", jsonNumber(counts.error)}};
}

/// The project as it is to be shown: other resolution or density where asked for.
Result<Project> projectOf(const Options& options) {
  Result<Project> project = loadWithWarnings(options.file, options.outside);
  if (!project) return project;
  if (const Status used = useSolver(*project, options.solver); !used) return used.error();
  if (!options.resolution.empty()) {
    const auto cells = parsePair(options.resolution, kMaxRenderCells);
    if (!cells) return pairExpected("--resolution", options.resolution, kMaxRenderCells, "cells");
    FieldSettings field = *project->field;
    field.resolution = *cells;
    project->field = std::make_shared<FieldSettings>(field);
  }
  GrassSettings grass = *project->grass;
  if (options.density) grass.density = static_cast<float>(*options.density);
  if (options.grass == "none") grass.kind = GrassKind::None;
  if (options.grass == "instanced") grass.kind = GrassKind::Instanced;
  if (options.grass == "bezier") grass.kind = GrassKind::Bezier;
  if (options.grass == "shell") grass.kind = GrassKind::Shell;
  if (options.deformation == "arc") grass.deformation = Deformation::Arc;
  if (options.deformation == "quadratic") grass.deformation = Deformation::Quadratic;
  if (options.deformation == "inertial") grass.deformation = Deformation::Inertial;
  if (options.density) {
    Project denser = *project;
    denser.grass = std::make_shared<GrassSettings>(grass);
    // A file with so many blades would be refused.
    if (const auto problems = validateChange(denser, *project); !problems.empty())
      return usage("--density " + plain(*options.density) + ": " + problems.front().message);
  }
  project->grass = std::make_shared<GrassSettings>(grass);
  return project;
}

/// As in a project file.
double mostDensity() {
  for (const Parameter<GrassSettings>& parameter : parametersOf<GrassSettings>())
    if (parameter.info.key == "density") return parameter.info.max;
  return 0;
}

/// IMG.png, or IMG.0000.png and so on where there are several.
std::filesystem::path imagePath(const Options& options, int frame) {
  std::filesystem::path path(options.out);
  if (options.frames == 1) return path;
  char number[16];
  std::snprintf(number, sizeof number, ".%04d", frame);
  const std::string extension = path.extension().string();
  path.replace_extension();
  path += number + extension;
  return path;
}

Status savePicture(const gpu::Framebuffer& target, const std::filesystem::path& path) {
  const std::vector<unsigned char> rgba = target.readRgba8();
  // Rather no picture than one that isn't what the project says.
  if (gpu::gpuWasReset()) return makeError(ErrorKind::Machine, gpu::kGpuLost);
  if (const gpu::MemoryFailures failed = gpu::memoryFailures(); failed.count > 0)
    return makeError(ErrorKind::Machine, failed.last);
  Image image(target.size().x, target.size().y, 3);
  for (std::size_t i = 0; i * 4 < rgba.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) image.pixels[i * 3 + c] = rgba[i * 4 + c];
  }
  return writePng(path, image);
}

/// False where the user interrupted.
bool simulateTo(Session& session, double until, double end, Progress& progress) {
  while (session.time() + 1e-9 < until) {
    if (interrupted()) return false;
    const double before = session.time();
    session.runTo(std::min(until, before + kSlice));
    if (session.time() <= before) break;  // less than half a step away
    progress.show("simulating", end > 0 ? session.time() / end : 1.0);
  }
  return !interrupted();
}

struct Studio {
  std::unique_ptr<gpu::Context> context;
  std::unique_ptr<gpu::ShaderLibrary> shaders;
  gpu::Framebuffer target;
  std::unique_ptr<Session> session;
};

Result<Studio> openStudio(const Options& options, const Project& project, glm::ivec2 size) {
  Studio studio;
  Result<std::unique_ptr<gpu::Context>> context = gpu::createOffscreenContext();
  if (!context) return context.error();
  studio.context = std::move(*context);
  Result<std::unique_ptr<gpu::ShaderLibrary>> shaders = gpu::ShaderLibrary::create();
  if (!shaders) return shaders.error();
  studio.shaders = std::move(*shaders);
  Result<gpu::Framebuffer> target = gpu::Framebuffer::create("picture", size, {.colour = GL_RGBA8, .depth = 0});
  if (!target) return target.error();
  studio.target = std::move(*target);
  SessionOptions sessionOptions;
  sessionOptions.context = studio.context.get();
  sessionOptions.shaders = studio.shaders.get();
  sessionOptions.backend = options.backend;
  sessionOptions.liveGrid = LiveGrid::Full;
  Result<std::unique_ptr<Session>> session = Session::create(project, sessionOptions);
  if (!session) return session.error();
  studio.session = std::move(*session);
  return studio;
}

void report(const Options& options, const Studio& studio, const std::vector<std::string>& images, GrassKind kind) {
  const SessionStatus& status = studio.session->status();
  if (!options.json) {
    for (const std::string& image : images) std::printf("%s\n", printable(image).c_str());
    return;
  }
  Json told = {{"ok", true},
               {"file", options.file},
               {"images", images},
               {"time", studio.session->time()},
               {"backend", status.backend == Backend::Gpu ? "gpu" : "cpu"},
               {"resolution", {status.liveResolution.x, status.liveResolution.y}},
               {"renderer", studio.context->info().renderer},
               {"blades", status.frame.bladesTotal}};
  if (kind == GrassKind::Bezier) told["bezier"] = bezierCountsJson(status.frame.bezier);
  if (kind == GrassKind::Shell) told["shell"] = shellCountsJson(status.frame.shell);
  printJson(told);
}

Session::View viewOf(const Options& options, const ViewCamera& camera, const Overlays& overlays, const Studio& studio) {
  Session::View view;
  view.camera = camera;
  view.size = studio.target.size();
  view.framebuffer = studio.target.name();
  view.overlays = overlays;
  view.quality.detail = options.fullQuality || options.everyBlade ? 1.0f : static_cast<float>(options.detail);
  view.quality.still = options.fullQuality || options.everyBlade;
  view.quality.thinning = !options.everyBlade;
  applyBezierOptions(options.bezier, view);
  return view;
}

int render(const Options& options) {
  const auto kinds = {"instanced", "bezier", "shell", "none"};
  if (!options.grass.empty() && std::ranges::find(kinds, options.grass) == kinds.end()) {
    return reportError(usage("--grass: found '" + options.grass + "', expected instanced, bezier, shell or none"),
                       options);
  }
  if (const Status there = requireFolderOf(options.out); !there) return reportError(there.error(), options);
  const auto size = parsePair(options.size, kMaxRenderSide);
  if (!size) return reportError(pairExpected("--size", options.size, kMaxRenderSide, "pixels"), options);
  const Result<Overlays> overlays = overlaysByName(options.overlays);
  if (!overlays) return reportError(overlays.error(), options);
  const Result<Project> project = projectOf(options);
  if (!project) return reportError(project.error(), options);
  const Result<ViewCamera> camera = cameraOf(options, *project);
  if (!camera) return reportError(camera.error(), options);
  Result<Studio> studio = openStudio(options, *project, *size);
  if (!studio) return reportError(studio.error(), options);

  noteInterrupts();
  Progress progress;
  const Session::View view = viewOf(options, *camera, *overlays, *studio);
  std::vector<std::string> images;
  const double end = options.time + (options.frames - 1) / options.fps;
  for (int frame = 0; frame < options.frames; ++frame) {
    if (!simulateTo(*studio->session, options.time + frame / options.fps, end, progress)) return kExitInterrupted;
    studio->session->draw(view);
    const std::filesystem::path path = imagePath(options, frame);
    if (const Status saved = savePicture(studio->target, path); !saved) return reportError(saved.error(), options);
    images.push_back(path.string());
  }
  const GrassKind kind = project->grass->kind;
  // Counts come with a later frame.
  if (options.json && (kind == GrassKind::Bezier || kind == GrassKind::Shell)) studio->session->draw(view);
  report(options, *studio, images, kind);
  return kExitDone;
}

}  // namespace

VerbAction makeRenderVerb(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("file", options->file, "Project file (NAME.wind.json)")->required();
  app.add_option("--out", options->out, "Picture to write; several become IMG.0000.png and so on")
      ->type_name("IMG.png")
      ->check(pngName())
      ->required();
  app.add_option("--time", options->time, "Moment of the (first) picture in seconds")
      ->type_name("S")
      ->check(numberFrom(0.0, kMaxSeconds));
  app.add_option("--frames", options->frames, "How many pictures")
      ->type_name("N")
      ->transform(wholeFrom(1, kMaxRenderFrames));
  app.add_option("--fps", options->fps, "Pictures a second of simulated time (default 30)")
      ->type_name("N")
      ->check(numberFrom(0.01, 1000.0));
  app.add_option("--size", options->size, "Pixels (default 1280x720)")->type_name("WxH");
  app.add_option("--camera", options->camera,
                 "Camera of the project, or above (default: the first, else one that shows the field)")
      ->type_name("NAME");
  std::vector<std::string> overlays{"none"};
  for (const OverlayKind& kind : overlayKinds()) overlays.emplace_back(kind.name);
  offer(app.add_option("--overlay", options->overlays, overlayNames() + " (the default)")
            ->type_name("NAME[,NAME]")
            ->delimiter(',')
            ->allow_extra_args(false),
        overlays);
  app.add_option("--resolution", options->resolution, "Cells of the wind instead of the project's")->type_name("WxH");
  addSolverOption(app, options->solver);
  offer(app.add_option("--grass", options->grass,
                       "Kind of grass instead of the project's: instanced, bezier, shell, none")
            ->type_name("KIND"),
        {"instanced", "bezier", "shell", "none"});
  app.add_option("--deformation", options->deformation,
                 "How blades bend instead of the project's: arc, quadratic, inertial")
      ->type_name("NAME")
      ->check(oneOf({"arc", "quadratic", "inertial"}));
  app.add_option("--density", options->density, "Blades per square metre instead of the project's")
      ->type_name("N")
      ->check(numberFrom(0.0, mostDensity()));
  app.add_option("--detail", options->detail, "Part of the grass's full detail, 0.02 to 1 (default 1)")
      ->type_name("D")
      ->check(numberFrom(0.02, 1.0));
  app.add_flag("--full-quality", options->fullQuality, "Everything as fine as it gets, however long it takes");
  app.add_flag("--every-blade", options->everyBlade,
               "Full quality, and every blade in sight drawn, however small: needs much memory");
  addBezierOptions(app, options->bezier);
  addProjectOptions(app, *options);
  addCommonOptions(app, *options);
  app.footer("Needs OpenGL 4.5; a software renderer will do. With one the wind is computed by the CPU backend.");
  return [options] { return render(*options); };
}

}  // namespace windloom::cli
