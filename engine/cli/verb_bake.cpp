#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "engine/bake/bake.hpp"
#include "engine/cli/common.hpp"
#include "engine/cli/interrupt.hpp"
#include "engine/cli/option_checks.hpp"
#include "engine/cli/option_limits.hpp"
#include "engine/cli/program_help.hpp"
#include "engine/cli/progress.hpp"
#include "engine/cli/project_option.hpp"
#include "engine/cli/verbs.hpp"
#include "engine/cli/wind_context.hpp"
#include "engine/cli/words.hpp"
#include "engine/core/log.hpp"
#include "engine/core/text.hpp"

namespace windloom::cli {
namespace {

struct Options : CommonOptions, ProjectOptions, RunOptions {
  std::string file, out, resolution, part;
  std::string preset = "generic", space = "world";
  std::vector<std::string> formats;
  std::optional<double> from, seconds, fps, speedRange, warmUp;
  std::optional<long> steps;
  HeightProfile profile;
  bool listFormats = false;
  bool loop = false, response = false, graph = false, noSidecars = false;
};

constexpr double kDefaultSeconds = 2, kDefaultFps = 30;

std::string namesOf(const auto& list) {
  std::string names;
  for (const auto& entry : list) names += (names.empty() ? "" : ", ") + std::string(entry.name);
  return names;
}

std::vector<std::string> listOf(const auto& list) {
  std::vector<std::string> names;
  for (const auto& entry : list) names.emplace_back(entry.name);
  return names;
}

std::optional<glm::ivec2> parseResolution(const std::string& text) {
  const auto cross = text.find_first_of("xX");
  if (cross == std::string::npos) return std::nullopt;
  const auto width = parseNumber(text.substr(0, cross)), height = parseNumber(text.substr(cross + 1));
  const auto sensible = [](const std::optional<double>& side) {
    return side && *side >= 1 && *side <= kMaxBakeSide && *side == std::floor(*side);
  };
  if (!sensible(width) || !sensible(height)) return std::nullopt;
  return glm::ivec2(*width, *height);
}

/// "3-17", or "5" for one frame.
std::optional<std::pair<int, int>> parsePart(const std::string& text) {
  const auto dash = text.find('-');
  const auto first = parseNumber(text.substr(0, dash));
  const auto last = dash == std::string::npos ? first : parseNumber(text.substr(dash + 1));
  const auto sensible = [](const std::optional<double>& frame) {
    return frame && *frame >= 0 && *frame < kMaxBakeFrames && *frame == std::floor(*frame);
  };
  if (!sensible(first) || !sensible(last) || *first > *last) return std::nullopt;
  return std::pair(static_cast<int>(*first), static_cast<int>(*last));
}

/// Who gives one number may have meant how many frames.
Error withLengthHint(const Options& options, Error error) {
  if (error.kind != ErrorKind::Usage || options.part.empty() || options.part.find('-') != std::string::npos)
    return error;
  error.problems.back().message +=
      "; --frames takes a range A-B (" + options.part + " alone is that one frame); the length is --seconds";
  return error;
}

/// Which frames: --steps alone gives the one field that many steps after --from; with --fps all frames up to there.
Result<RecordPlan> planOf(const Options& options, const Project& project) {
  RecordPlan plan;
  plan.from = options.from.value_or(options.initialTime);
  if (plan.from < options.initialTime) {
    return makeError(ErrorKind::Usage, "--from lies before --initial-time");
  }
  if (options.warmUp && *options.warmUp > plan.from) {
    return makeError(ErrorKind::Usage, "--warm-up " + plain(*options.warmUp) +
                                           " begins before the project's time 0; use --from " + plain(*options.warmUp) +
                                           " or later");
  }
  plan.fps = options.fps.value_or(kDefaultFps);
  double frames = 1;
  if (options.steps) {
    const double seconds = static_cast<double>(*options.steps) * static_cast<double>(project.field->timeStep);
    if (options.fps) {
      frames = std::floor(seconds * plan.fps + 1e-6) + 1;
    } else {
      plan.from += seconds;
    }
  } else {
    frames = std::max(1.0, std::round(options.seconds.value_or(kDefaultSeconds) * plan.fps));
  }
  if (frames > kMaxBakeFrames) {
    return makeError(ErrorKind::Usage, "that is " + fixed(frames, 0) + " frames, at most " +
                                           std::to_string(kMaxBakeFrames) +
                                           " can be baked; use less --seconds or --fps");
  }
  plan.frames = static_cast<int>(frames);
  plan.crossfade = options.loop ? crossfadeFor(plan.frames) : 0;
  return plan;
}

Result<BakeRequest> requestOf(const Options& options, const Project& project) {
  BakeRequest request;
  request.folder = options.out;
  request.loop = options.loop;
  for (std::string name : options.formats) {
    std::erase(name, ' ');
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const WriterKind* kind = writerKindNamed(name);
    if (kind == nullptr) {
      return makeError(ErrorKind::Usage, "--format: found '" + name + "', expected one of " + namesOf(writerKinds()));
    }
    if (std::find(request.formats.begin(), request.formats.end(), kind) == request.formats.end())
      request.formats.push_back(kind);
  }
  const std::optional<Preset> preset = presetNamed(options.preset);
  if (!preset) {
    return makeError(ErrorKind::Usage,
                     "--preset: found '" + options.preset + "', expected one of " + namesOf(presets()));
  }
  request.preset = *preset;
  if (!options.resolution.empty()) {
    request.resolution = parseResolution(options.resolution);
    if (!request.resolution) {
      return makeError(ErrorKind::Usage, "--resolution: found '" + options.resolution +
                                             "', expected WxH in cells, 1 to " + std::to_string(kMaxBakeSide) +
                                             " a side");
    }
  }
  if (options.speedRange) request.fullScale = static_cast<float>(*options.speedRange);
  request.space = options.space == "uv" ? FlowSpace::Uv : FlowSpace::World;
  request.profile = options.profile;
  request.response = options.response;
  request.graph = options.graph;
  request.sidecars = !options.noSidecars;
  if (!options.part.empty()) {
    request.part = parsePart(options.part);
    if (!request.part) {
      return withLengthHint(options, makeError(ErrorKind::Usage, "--frames: found '" + options.part +
                                                                     "', expected A-B, both counted from 0"));
    }
  }
  const Result<RecordPlan> plan = planOf(options, project);
  if (!plan) return plan.error();
  request.plan = *plan;
  return request;
}

/// "7", "3-17"
std::string rangeText(int first, int last) {
  return std::to_string(first) + (first == last ? "" : "-" + std::to_string(last));
}

/// "30 frames", or of a part "frame 7 of 30".
std::string framesOf(const BakeHeader& header) {
  const int written = header.last - header.first + 1;
  if (written >= header.frames) return counted(static_cast<std::uint64_t>(header.frames), "frame");
  return (written == 1 ? "frame " : "frames ") + rangeText(header.first, header.last) + " of " +
         std::to_string(header.frames);
}

/// Which frames are missing, and where the others are until then: in a folder that `ls` doesn't list.
void printMissing(const Options& options, const BakeReport& report) {
  std::string missing;
  for (const auto& [first, last] : report.missing) missing += (missing.empty() ? "" : ", ") + rangeText(first, last);
  const bool one = report.missing.size() == 1 && report.missing.front().first == report.missing.front().second;
  std::printf("part of a bake: %s %s still missing (%s, counted from 0)", one ? "frame" : "frames",
              (missing + (one ? " is" : " are")).c_str(), counted(report.missing.size(), "range").c_str());
  if (!report.files.empty()) {
    const auto folder = std::filesystem::path(options.out) / std::filesystem::path(report.files.front()).parent_path();
    std::printf("; until then the files wait in %s", folder.c_str());
  }
  std::printf("\n");
}

void printReport(const Options& options, const BakeReport& report, Backend backend, double wallSeconds) {
  const BakeHeader& header = report.header;
  if (options.json) {
    Json json = {{"ok", true},
                 {"folder", options.out},
                 {"files", report.files},
                 {"bytes", report.bytes},
                 {"frames", header.frames},
                 {"fps", header.fps},
                 {"grid", {header.grid.resolution.x, header.grid.resolution.y}},
                 {"steps", report.steps},
                 {"complete", report.complete},
                 {"backend", backendName(backend)},
                 {"fastest", jsonNumber(header.fastest)},
                 {"wallSeconds", wallSeconds}};
    if (!report.complete) json["missing"] = report.missing;
    if (header.crossfade > 0 && report.complete)
      json["seam"] = {{"change", jsonNumber(report.seam.seam)}, {"largestStep", jsonNumber(report.seam.step)}};
    printJson(json);
    return;
  }
  std::printf("%s: %s, %s MB: %s of %d x %d cells at %s a second, fastest wind %s m/s (%s, %s s)\n",
              printable(options.out).c_str(), counted(report.files.size(), "file").c_str(),
              fixed(static_cast<double>(report.bytes) / 1e6, 1).c_str(), framesOf(header).c_str(),
              header.grid.resolution.x, header.grid.resolution.y, plain(header.fps).c_str(),
              fixed(static_cast<double>(header.fastest), 2).c_str(), backendName(backend),
              fixed(wallSeconds, 1).c_str());
  if (header.crossfade > 0 && report.complete) {
    std::printf("loop: from the last frame to the first the wind changes by at most %s m/s, between others by %s m/s\n",
                fixed(static_cast<double>(report.seam.seam), 2).c_str(),
                fixed(static_cast<double>(report.seam.step), 2).c_str());
  }
  if (!report.complete) printMissing(options, report);
}

int listFormats(const Options& options) {
  Json all = Json::array();
  for (const WriterKind& kind : writerKinds()) {
    all.push_back({{"name", kind.name},
                   {"group", kind.group},
                   {"help", kind.help},
                   {"numbered", kind.numbered},
                   {"missing", kind.missing}});
    if (!options.json) std::printf("%-14s  %s\n", std::string(kind.name).c_str(), std::string(kind.help).c_str());
    if (!options.json && !kind.missing.empty()) std::printf("%-14s  %s\n", "", std::string(kind.missing).c_str());
  }
  if (options.json) printJson({{"ok", true}, {"formats", all}});
  return kExitDone;
}

int runBake(const Options& options) {
  if (options.listFormats) return listFormats(options);
  for (const auto& [given, name] : {std::pair(!options.file.empty(), "the project FILE"),
                                    {!options.out.empty(), "--out DIR"},
                                    {!options.formats.empty(), "--format F"}}) {
    if (!given) return reportError(makeError(ErrorKind::Usage, std::string("expected ") + name), options);
  }
  const auto start = std::chrono::steady_clock::now();
  Result<Project> project = loadWithWarnings(options.file, options.outside);
  if (!project) return reportError(project.error(), options);
  if (const Status used = useSolver(*project, options.solver); !used) return reportError(used.error(), options);
  const Result<BakeRequest> request = requestOf(options, *project);
  if (!request) return reportError(request.error(), options);
  const Result<WindContext> wind = openWindContext(options.backend, *project);
  if (!wind) return reportError(wind.error(), options);
  Result<std::unique_ptr<Simulation>> made = makeSimulation(*project, options.backend, *wind, options.threads);
  if (!made) return reportError(made.error(), options);
  Simulation& simulation = **made;
  if (!options.initial.empty()) {
    if (const Status loaded = loadInitialField(simulation, options.initial, options.initialTime); !loaded)
      return reportError(loaded.error(), options);
  }
  if (options.warmUp) simulation.startAt(request->plan.from - *options.warmUp);
  for (const WriterKind* kind : request->formats) {
    const std::string warning = kind->warning != nullptr ? kind->warning(headerOf(*project, *request)) : "";
    if (!warning.empty()) logWarning(std::string(kind->name) + ": " + warning);
  }
  noteInterrupts();
  Result<BakeReport> report = BakeReport{};
  {
    Progress progress;
    report = bake(simulation, *request, [&](const BakeProgress& p) {
      progress.show(p.phase == BakePhase::Recording ? "recording" : "writing", p.part);
      return !interrupted();
    });
  }
  if (!report) return reportError(withLengthHint(options, report.error()), options);
  if (report->cancelled) {
    reportError(makeError(ErrorKind::Machine, "the bake was cancelled; nothing was written"), options);
    return kExitInterrupted;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  printReport(options, *report, simulation.solver().backend(), wall.count());
  return kExitDone;
}

}  // namespace

VerbAction makeBakeVerb(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("file", options->file, "Project file (NAME.wind.json)");
  app.add_option("--out", options->out, "Folder for the files, made if needed")->type_name("DIR");
  offer(app.add_option("--format", options->formats, "What to write, separated by commas: " + namesOf(writerKinds()))
            ->type_name("F[,F...]")
            ->delimiter(',')
            ->allow_extra_args(false),
        listOf(writerKinds()));
  app.add_flag("--list-formats", options->listFormats, "List the formats and write nothing");
  offer(app.add_option("--preset", options->preset, "Axes, units and image rows of an engine: " + namesOf(presets()))
            ->type_name("NAME")
            ->capture_default_str(),
        listOf(presets()));
  app.add_option("--from", options->from, "Moment of the first frame, s (default: the start)")
      ->type_name("S")
      ->check(numberFrom(0.0, kMaxSeconds));
  auto* seconds = app.add_option("--seconds", options->seconds, "Length of the recording, s (default 2)")
                      ->type_name("S")
                      ->check(numberFrom(1e-6, kMaxSeconds));
  app.add_option("--fps", options->fps, "Frames a second (default 30)")
      ->type_name("N")
      ->check(numberFrom(0.01, 10000.0));
  app.add_option("--steps", options->steps,
                 "Count in solver steps: write the one field N steps after --from, or with --fps all frames up to it")
      ->type_name("N")
      ->transform(wholeFrom(0, kMaxSteps))
      ->excludes(seconds);
  app.add_option("--resolution", options->resolution,
                 "Cells of the written frames; the wind always runs on the project's (default: the same)")
      ->type_name("WxH");
  app.add_flag("--loop", options->loop, "Blend the end into the start, so that the recording repeats without a jump");
  app.add_option("--frames", options->part,
                 "Write only frames A to B of the recording, counted from 0, or one: A. They have the same bytes as in "
                 "the whole: for render farms. Bakes of other ranges into the same folder complete it")
      ->type_name("A-B");
  app.add_option("--warm-up", options->warmUp,
                 "Let the wind blow only so long before --from, instead of from the project's start, s")
      ->type_name("S")
      ->check(numberFrom(0.0, kMaxSeconds));
  app.add_option("--space", options->space,
                 "What images hold: world velocity, or uv: texture coordinates a second for panning shaders")
      ->check(oneOf({"world", "uv"}))
      ->capture_default_str();
  app.add_flag("--response", options->response,
               "Also how plants of four stiffnesses lean (rad), solved with springs, in every format");
  app.add_flag("--graph", options->graph, "Also the arrow graph as graph.gltf");
  app.add_flag("--no-sidecars", options->noSidecars, "No how-to, shader code and import settings beside the files");
  app.add_option("--layers", options->profile.layers, "Layers of volumes, from the ground up")
      ->type_name("N")
      ->transform(wholeFrom(1, kMaxBakeLayers))
      ->capture_default_str();
  app.add_option("--top", options->profile.top, "Height of volumes, m")
      ->type_name("M")
      ->check(numberFrom(0.1, 1000.0))
      ->capture_default_str();
  app.add_option("--reference-height", options->profile.reference,
                 "Height at which the wind is as the field says; below and above it follows the logarithmic law, m")
      ->type_name("M")
      ->check(numberFrom(0.01, 1000.0))
      ->capture_default_str();
  app.add_option("--roughness", options->profile.roughness, "Roughness length of the ground, m (grass 0.03, forest 1)")
      ->type_name("M")
      ->check(numberFrom(1e-4, 10.0))
      ->capture_default_str();
  addRunOptions(app, *options);
  app.add_option("--vmax", options->speedRange, "Speed that flow maps encode as full scale, m/s (default: the fastest)")
      ->type_name("V")
      ->check(numberFrom(1e-3, 1e4));
  addProjectOptions(app, *options);
  addCommonOptions(app, *options);
  std::string footer = "Formats, each listed with its checksum in manifest.json:\n";
  for (const WriterKind& kind : writerKinds())
    footer += "  " + std::string(kind.name) + ": " + std::string(kind.help) + "\n";
  footer += "Presets:\n";
  for (const PresetRules& rules : presets())
    footer += "  " + std::string(rules.name) + ": " + std::string(rules.help) + "\n";
  app.footer(footer + "Ctrl+C ends a bake without leaving files.");
  return [options] { return runBake(*options); };
}

}  // namespace windloom::cli
