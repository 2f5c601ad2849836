#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "engine/bake/bake.hpp"
#include "engine/cli/common.hpp"
#include "engine/cli/interrupt.hpp"
#include "engine/cli/option_checks.hpp"
#include "engine/cli/option_limits.hpp"
#include "engine/cli/progress.hpp"
#include "engine/cli/project_option.hpp"
#include "engine/cli/verbs.hpp"
#include "engine/cli/wind_context.hpp"
#include "engine/cli/words.hpp"
#include "engine/core/text.hpp"

namespace windloom::cli {
namespace {

struct Options : CommonOptions, ProjectOptions, RunOptions {
  std::string file;
  std::vector<std::string> at;
  double time = 0;
};

struct Place {
  std::string name;
  glm::vec2 position;
};

std::optional<glm::vec2> parsePosition(const std::string& text) {
  const auto comma = text.find(',');
  if (comma == std::string::npos) return std::nullopt;
  const auto x = parseNumber(text.substr(0, comma)), z = parseNumber(text.substr(comma + 1));
  if (!x || !z) return std::nullopt;
  return glm::vec2(*x, *z);
}

Error outsideError(const Options& options, const Place& place, const FieldSettings& field) {
  const glm::vec2 low = field.centre - field.size * 0.5f, high = field.centre + field.size * 0.5f;
  return makeError(ErrorKind::BadInput, options.file, {},
                   place.name + " lies outside the field, which goes from x " + plain(low.x) + " to " + plain(high.x) +
                       " and z " + plain(low.y) + " to " + plain(high.y));
}

/// The places asked for, or the project's probes.
Result<std::vector<Place>> placesOf(const Options& options, const Project& project) {
  std::vector<Place> places;
  for (const std::string& text : options.at) {
    const std::optional<glm::vec2> position = parsePosition(text);
    if (!position) return makeError(ErrorKind::Usage, "--at: found '" + text + "', expected X,Z in metres");
    places.push_back({plain(position->x) + "," + plain(position->y), *position});
  }
  if (places.empty()) {
    for (const Probe& probe : *project.probes) {
      places.push_back({probe.name.empty() ? "probe " + std::to_string(probe.id) : probe.name, probe.position});
    }
  }
  if (places.empty()) return makeError(ErrorKind::Usage, "--at X,Z is needed, since the project has no probes");
  for (const Place& place : places) {
    const glm::vec2 fromCentre = glm::abs(place.position - project.field->centre) - project.field->size * 0.5f;
    if (!(fromCentre.x <= 0.0f && fromCentre.y <= 0.0f)) return outsideError(options, place, *project.field);
  }
  return places;
}

/// Degrees from +X towards +Z in which the air goes; 0 for still air.
double directionOf(glm::vec2 velocity) {
  const double degrees =
      std::atan2(static_cast<double>(velocity.y), static_cast<double>(velocity.x)) * 180.0 / std::numbers::pi;
  return degrees < 0 ? degrees + 360.0 : degrees;
}

void printSampleJson(const Options& options, Simulation& simulation, const std::vector<Place>& places) {
  Json samples = Json::array();
  for (const Place& place : places) {
    const glm::vec2 v = simulation.windAt(place.position);
    samples.push_back({{"name", place.name},
                       {"at", {jsonNumber(place.position.x), jsonNumber(place.position.y)}},
                       {"velocity", {jsonNumber(v.x), jsonNumber(v.y)}},
                       {"speed", jsonNumber(glm::length(v))},
                       {"direction", directionOf(v)}});
  }
  const glm::ivec2 cells = simulation.solver().grid().resolution;
  printJson({{"ok", true},
             {"file", options.file},
             {"time", simulation.time()},
             {"steps", simulation.steps()},
             {"backend", backendName(simulation.solver().backend())},
             {"resolution", {cells.x, cells.y}},
             {"samples", samples},
             {"diagnostics", diagnosticsJson(simulation.solver().diagnostics())}});
}

void printSampleTable(Simulation& simulation, const std::vector<Place>& places) {
  std::size_t width = 5;
  for (const Place& place : places) width = std::max(width, printable(place.name).size());
  std::printf("wind after %s s (%s, %s)\n", fixed(simulation.time(), 3).c_str(),
              counted(static_cast<std::uint64_t>(simulation.steps()), "step").c_str(),
              backendName(simulation.solver().backend()));
  std::printf("%-*s  speed m/s  direction deg   vx m/s   vz m/s\n", static_cast<int>(width), "place");
  for (const Place& place : places) {
    const glm::vec2 v = simulation.windAt(place.position);
    std::printf("%-*s  %9s  %13s  %7s  %7s\n", static_cast<int>(width), printable(place.name).c_str(),
                fixed(static_cast<double>(glm::length(v)), 3).c_str(), fixed(directionOf(v), 1).c_str(),
                fixed(static_cast<double>(v.x), 3).c_str(), fixed(static_cast<double>(v.y), 3).c_str());
  }
}

int sample(const Options& options) {
  Result<Project> project = loadWithWarnings(options.file, options.outside);
  if (!project) return reportError(project.error(), options);
  if (const Status used = useSolver(*project, options.solver); !used) return reportError(used.error(), options);
  if (options.time < options.initialTime) {
    return reportError(makeError(ErrorKind::Usage, "--time lies before --initial-time"), options);
  }
  const Result<std::vector<Place>> places = placesOf(options, *project);
  if (!places) return reportError(places.error(), options);
  const Result<WindContext> wind = openWindContext(options.backend, *project);
  if (!wind) return reportError(wind.error(), options);
  Result<std::unique_ptr<Simulation>> made = makeSimulation(*project, options.backend, *wind, options.threads);
  if (!made) return reportError(made.error(), options);
  Simulation& simulation = **made;
  if (!options.initial.empty()) {
    if (const Status loaded = loadInitialField(simulation, options.initial, options.initialTime); !loaded)
      return reportError(loaded.error(), options);
  }
  noteInterrupts();
  Progress progress;
  const bool finished = simulation.runTo(options.time, [&](double time) {
    progress.show("simulating", time / options.time);
    return interrupted();
  });
  if (!finished) {
    reportError(makeError(ErrorKind::Machine, "cancelled before the moment was reached"), options);
    return kExitInterrupted;
  }
  if (options.json) {
    printSampleJson(options, simulation, *places);
  } else {
    printSampleTable(simulation, *places);
  }
  return kExitDone;
}

}  // namespace

VerbAction makeSampleVerb(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("file", options->file, "Project file (NAME.wind.json)")->required();
  app.add_option("--at", options->at, "Place in metres; may be given more than once (default: the project's probes)")
      ->type_name("X,Z")
      ->allow_extra_args(false);
  app.add_option("--time", options->time, "Moment in seconds, rounded to whole time steps")
      ->type_name("T")
      ->check(numberFrom(0.0, kMaxSeconds))
      ->required();
  addRunOptions(app, *options);
  addProjectOptions(app, *options);
  addCommonOptions(app, *options);
  app.footer("Speeds in m/s. A direction is where the air goes to, in degrees from +X towards +Z.");
  return [options] { return sample(*options); };
}

}  // namespace windloom::cli
