#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>

#include "engine/cli/bench.hpp"
#include "engine/cli/option_checks.hpp"
#include "engine/cli/option_limits.hpp"
#include "engine/cli/program_help.hpp"
#include "engine/cli/verbs.hpp"
#include "engine/core/file.hpp"
#include "engine/core/log.hpp"

namespace windloom::cli {
namespace {

struct Options : CommonOptions {
  std::vector<std::string> scenes, views;
  std::string jsonFile, size, pictures;
  std::vector<int> cells, blades;
  bool quick = false;
};

std::string sceneNames() {
  std::string names;
  for (const BenchScene& scene : benchScenes()) names += (names.empty() ? "" : ", ") + std::string(scene.name);
  return names;
}

const BenchScene* findScene(const std::string& name) {
  for (const BenchScene& scene : benchScenes()) {
    if (scene.name == name) return &scene;
  }
  return nullptr;
}

Result<std::vector<const BenchScene*>> scenesOf(const Options& options) {
  std::vector<const BenchScene*> scenes;
  for (const std::string& name : options.scenes) {
    const BenchScene* scene = findScene(name);
    if (scene == nullptr) {
      return makeError(ErrorKind::Usage, "found the scene '" + name + "', expected one of " + sceneNames());
    }
    scenes.push_back(scene);
  }
  if (scenes.empty()) {
    for (const BenchScene& scene : benchScenes()) scenes.push_back(&scene);
  }
  if (findScene(options.jsonFile) != nullptr) {
    return makeError(ErrorKind::Usage, "--json takes a file name here; name the scenes before it");
  }
  return scenes;
}

/// UTC, as in 2025-01-31T12:00:00Z.
std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

struct OpenGl {
  std::unique_ptr<gpu::Context> context;
  std::unique_ptr<gpu::ShaderLibrary> shaders;
};

/// OpenGL for the scenes that draw or compute on it. With the CPU backend asked for there is none; a software renderer
/// is taken only where the GPU was asked for by name.
Result<OpenGl> openGlFor(Backend backend) {
  OpenGl gl;
  if (backend == Backend::Cpu) return gl;
  Result<std::unique_ptr<gpu::Context>> context = gpu::createOffscreenContext();
  if (!context) {
    if (backend == Backend::Gpu) return context.error();
    logInfo("no OpenGL here; only the CPU is measured");
    return gl;
  }
  if ((*context)->info().software && backend == Backend::Auto) {
    logInfo((*context)->info().renderer +
            " is a software renderer; only the CPU is measured (--backend gpu measures it)");
    return gl;
  }
  Result<std::unique_ptr<gpu::ShaderLibrary>> shaders = gpu::ShaderLibrary::create();
  if (!shaders) return shaders.error();
  gl.context = std::move(*context);
  gl.shaders = std::move(*shaders);
  return gl;
}

int runBench(const Options& options) {
  CommonOptions common = options;
  common.json = options.jsonFile == "-";
  const Result<std::vector<const BenchScene*>> scenes = scenesOf(options);
  if (!scenes) return reportError(scenes.error(), common);
  BenchSetup setup;
  if (!options.size.empty()) {
    setup.picture = parsePair(options.size, kMaxBenchPictureSide);
    if (!setup.picture)
      return reportError(pairExpected("--size", options.size, kMaxBenchPictureSide, "pixels"), common);
  }
  const Result<OpenGl> gl = openGlFor(options.backend);
  if (!gl) return reportError(gl.error(), common);
  setup.size = options.quick ? BenchSize::Quick : BenchSize::Full;
  setup.cells = options.cells;
  setup.blades = options.blades;
  setup.views = options.views;
  setup.pictures = options.pictures;
  setup.cpu = options.backend != Backend::Gpu;
  setup.context = gl->context.get();
  setup.shaders = gl->shaders.get();
  setup.capSeconds = options.quick ? 1 : 20;
  Json report = {{"ok", true},
                 {"format", "windloom-bench"},
                 {"version", 1},
                 {"date", now()},
                 {"machine", benchMachine(setup.context)},
                 {"settings", {{"quick", options.quick}, {"cpu", setup.cpu}, {"gpu", setup.context != nullptr}}},
                 {"scenes", Json::object()}};
  for (const BenchScene* scene : *scenes) {
    const Result<std::vector<BenchRow>> rows = scene->run(setup);
    if (!rows) return reportError(rows.error(), common);
    if (!common.json && !rows->empty())
      printBenchTable(std::string(scene->name) + ": " + std::string(scene->help), *rows);
    report["scenes"][scene->name] = *rows;
  }
  if (common.json) {
    printJson(report);
  } else if (!options.jsonFile.empty()) {
    const std::string text = report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    if (const Status written = writeFileAtomically(options.jsonFile, text); !written) {
      return reportError(written.error(), common);
    }
  }
  return kExitDone;
}

}  // namespace

VerbAction makeBenchVerb(CLI::App& app) {
  auto options = std::make_shared<Options>();
  std::vector<std::string> names;
  for (const BenchScene& scene : benchScenes()) names.emplace_back(scene.name);
  offer(app.add_option("scene", options->scenes, "What to measure: " + sceneNames() + " (default: all)"), names);
  app.add_option("--json", options->jsonFile,
                 "Also write all numbers, the machine and the settings to FILE; '-' or no FILE "
                 "writes them to standard output instead of the tables")
      ->type_name("FILE")
      ->expected(0, 1)
      ->default_str("-");
  app.add_option("--cells", options->cells, "Scene solver: cells along a side of the fields, separated by commas")
      ->type_name("N[,N...]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(wholeFrom(16, 8192));
  app.add_option("--blades", options->blades, "Scenes meadow and picture: millions of blades, separated by commas")
      ->type_name("N[,N...]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(wholeFrom(1, 200));
  app.add_option("--views", options->views, "Scene picture: only these of eye, over, top")
      ->type_name("NAME[,NAME]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(oneOf({"eye", "over", "top"}));
  app.add_option("--size", options->size, "Pixels of the scenes that draw (default 1920x1080)")->type_name("WxH");
  app.add_option("--pictures", options->pictures,
                 "Scene picture: also write what it compares, and the differences, there")
      ->type_name("FOLDER");
  app.add_flag("--quick", options->quick, "Tiny sizes, to see that it runs");
  addBackendOption(app, *options);
  std::string footer = "Times are medians. Scenes:\n";
  for (const BenchScene& scene : benchScenes()) {
    footer += "  " + std::string(scene.name) + ": " + std::string(scene.help) + "\n";
  }
  app.footer(footer);
  return [options] { return runBench(*options); };
}

}  // namespace windloom::cli
