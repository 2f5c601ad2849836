#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>

#include "engine/bake/bake.hpp"
#include "engine/cli/common.hpp"
#include "engine/cli/option_checks.hpp"
#include "engine/cli/project_option.hpp"
#include "engine/cli/verbs.hpp"
#include "engine/cli/words.hpp"
#include "engine/core/text.hpp"
#include "engine/grass/bezier_placement.hpp"
#include "engine/grass/shell_texture.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/model/parameters.hpp"

namespace windloom::cli {
namespace {

struct Options : CommonOptions, ProjectOptions {
  std::string file;
  double fps = 30;
};

// Per cell and frame: the live field and .npy hold (vx, vz) as float32, the flow map is 8-bit RGBA.
constexpr int kFieldBytes = 8, kNpyBytes = 8, kFlowMapBytes = 4;

struct Sizes {
  std::int64_t cells, blades, field, npyPerSecond, flowMapPerSecond, shellTextures;
};

/// Of both textures of shell grass with all their levels.
std::int64_t bytesOf(const ShellTexture& texture) {
  std::int64_t bytes = 0;
  for (const ShellLevel& level : texture.levels)
    bytes += static_cast<std::int64_t>((level.form.size() + level.colour.size()) * sizeof(glm::u8vec4));
  return bytes;
}

ShellTexture shellTexture(const Project& project) {
  const ShellSettings& shell = *project.shell;
  return shell.pixels ? shellTextureOf(*shell.pixels, *project.grass, shell)
                      : makeShellTexture(*project.grass, shell, *project.species);
}

Sizes sizesOf(const Project& project, double fps) {
  const std::int64_t cells = std::int64_t{project.field->resolution.x} * project.field->resolution.y;
  const double area = static_cast<double>(project.field->size.x) * static_cast<double>(project.field->size.y);
  const auto perSecond = [&](int bytes) { return static_cast<std::int64_t>(static_cast<double>(cells * bytes) * fps); };
  auto blades = static_cast<std::int64_t>(area * static_cast<double>(shownDensity(*project.grass)));
  if (project.grass->kind == GrassKind::Bezier) blades = placeBezier(project).count;
  std::int64_t shellTextures = 0;
  if (project.grass->kind == GrassKind::Shell) {
    const ShellTexture texture = shellTexture(project);
    const double tile = static_cast<double>(texture.tileM) * static_cast<double>(texture.tileM);
    blades = std::llround(area / tile * static_cast<double>(texture.blades));
    shellTextures = bytesOf(texture);
  }
  return {cells, blades, cells * kFieldBytes, perSecond(kNpyBytes), perSecond(kFlowMapBytes), shellTextures};
}

/// Of one second of the wind in a format.
std::uint64_t exportBytes(const WriterKind& kind, const Project& project, double fps) {
  BakeRequest request;
  request.formats = {&kind};
  request.plan.fps = fps;
  request.plan.frames = std::max(1, static_cast<int>(std::lround(fps)));
  return kind.bytes(headerOf(project, request));
}

std::string_view signalName(const Project& project, Id root) {
  const Signal* signal = findSignal(*project.graph, root);
  const Signal fallback;
  const auto kind = static_cast<std::size_t>((signal != nullptr ? *signal : fallback).kind);
  for (const Parameter<Signal>& parameter : parametersOf<Signal>()) {
    if (parameter.info.key == "kind") return parameter.info.choices[kind];
  }
  return {};
}

template <class Record>
std::string label(const Record& record) {
  return std::to_string(record.id) + (record.name.empty() ? "" : " (" + printable(record.name) + ")");
}

/// The name of the value of a choice.
template <class Owner>
std::string_view choiceName(const Owner& owner, std::string_view key) {
  for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
    if (parameter.info.key == key)
      return parameter.info.choices[static_cast<std::size_t>(std::get<int>(parameter.get(owner)))];
  }
  return {};
}

struct Extent {
  glm::vec2 min, max;
};

Extent extentOf(const std::vector<Point>& points) {
  Extent extent{points.front().position, points.front().position};
  for (const Point& point : points) {
    extent.min = glm::min(extent.min, point.position);
    extent.max = glm::max(extent.max, point.position);
  }
  return extent;
}

std::string megabytes(double bytes) {
  return fixed(bytes / 1e6, 1) + " MB";
}
std::string metres(float value) {
  return plain(value);
}

Json vectorJson(glm::vec2 v) {
  return Json::array({jsonNumber(v.x), jsonNumber(v.y)});
}

std::string_view terrainName(const TerrainSettings& terrain) {
  return choiceName(terrain, "kind");
}

Json surfaceJson(const Surface& surface) {
  Json output{{"id", surface.id}, {"shape", choiceName(surface, "shape")}};
  if (surface.shape != SurfaceShape::Mesh) output["size"] = jsonNumber(surface.size);
  if (surface.shape == SurfaceShape::Mesh) output["file"] = surface.file;
  if (surface.mesh) output["triangles"] = surface.mesh->indices.size() / 3;
  output["density"] = jsonNumber(surface.density);
  return output;
}

void printSurfaces(const std::vector<Surface>& surfaces) {
  for (const Surface& surface : surfaces) {
    std::string what = std::string(choiceName(surface, "shape"));
    what += surface.shape == SurfaceShape::Mesh ? " " + printable(surface.file) : " of " + metres(surface.size) + " m";
    if (surface.mesh) what += ", " + counted(surface.mesh->indices.size() / 3, "triangle");
    std::printf("surface    %s: %s, %s blades per m^2\n", label(surface).c_str(), what.c_str(),
                metres(surface.density).c_str());
  }
}

void printRotors(const std::vector<Rotor>& rotors) {
  for (const Rotor& rotor : rotors) {
    std::printf("rotor      %s: %s m over the ground, throws air down at %s m/s\n", label(rotor).c_str(),
                metres(rotor.lift).c_str(), metres(rotor.speed).c_str());
  }
}

Json terrainJson(const TerrainSettings& terrain) {
  Json output{{"kind", terrainName(terrain)}};
  const HeightField* field = terrain.heights.get();
  if (field == nullptr) return output;
  const HeightSource& source = *field->source;
  output["file"] = terrain.file;
  output["low"] = vectorJson(field->low);
  output["size"] = vectorJson(field->size);
  output["lowest"] = jsonNumber(field->lowest());
  output["highest"] = jsonNumber(field->highest());
  output["samples"] = {source.samples.x, source.samples.y};
  if (source.triangles > 0) {
    output["triangles"] = source.triangles;
  } else {
    output["pixels"] = {source.pixels.x, source.pixels.y};
  }
  output["bytes"] = field->bytes();
  return output;
}

void printTerrain(const TerrainSettings& terrain) {
  const HeightField* field = terrain.heights.get();
  if (field == nullptr) {
    std::printf("terrain    flat\n");
    return;
  }
  const HeightSource& source = *field->source;
  const std::string from = source.triangles > 0
                               ? counted(static_cast<std::uint64_t>(source.triangles), "triangle")
                               : std::to_string(source.pixels.x) + " x " + std::to_string(source.pixels.y) + " pixels";
  std::printf("terrain    %s, %s, %s as %d x %d samples (%s)\n", std::string(terrainName(terrain)).c_str(),
              printable(terrain.file).c_str(), from.c_str(), source.samples.x, source.samples.y,
              megabytes(static_cast<double>(field->bytes())).c_str());
  std::printf("           x %s to %s m, z %s to %s m, %s to %s m high\n", metres(field->low.x).c_str(),
              metres(field->low.x + field->size.x).c_str(), metres(field->low.y).c_str(),
              metres(field->low.y + field->size.y).c_str(), metres(field->lowest()).c_str(),
              metres(field->highest()).c_str());
}

void printInfoJson(const Options& options, const Project& project, const std::vector<Id>& roots,
                   const std::vector<Arrival>& arrivals) {
  const FieldSettings& field = *project.field;
  const Sizes sizes = sizesOf(project, options.fps);
  Json output{{"ok", true}, {"file", options.file}, {"name", project.name}};
  output["field"] = {{"centre", vectorJson(field.centre)},
                     {"size", vectorJson(field.size)},
                     {"resolution", {field.resolution.x, field.resolution.y}},
                     {"cellSize", vectorJson(field.size / glm::vec2(field.resolution))},
                     {"timeStep", jsonNumber(field.timeStep)}};
  output["terrain"] = terrainJson(*project.terrain);
  output["counts"] = {{"points", project.graph->points.size()},
                      {"arrows", project.graph->arrows.size()},
                      {"signals", project.graph->signals.size()},
                      {"roots", roots.size()},
                      {"obstacles", project.obstacles->size()},
                      {"species", project.species->size()},
                      {"colliders", project.colliders->size()},
                      {"surfaces", project.surfaces->size()},
                      {"rotors", project.rotors->size()},
                      {"probes", project.probes->size()},
                      {"cameras", project.cameras->size()},
                      {"cells", sizes.cells},
                      {"blades", sizes.blades}};
  if (!project.graph->points.empty()) {
    const Extent extent = extentOf(project.graph->points);
    output["extent"] = {{"min", vectorJson(extent.min)}, {"max", vectorJson(extent.max)}};
  }
  output["grass"] = choiceName(*project.grass, "kind");
  output["surfaces"] = Json::array();
  for (const Surface& surface : *project.surfaces) output["surfaces"].push_back(surfaceJson(surface));
  output["roots"] = Json::array();
  for (const Id root : roots) output["roots"].push_back({{"id", root}, {"signal", signalName(project, root)}});
  output["arrivals"] = Json::array();
  for (std::size_t i = 0; i < arrivals.size(); ++i) {
    if (arrivals[i].root == 0) continue;
    output["arrivals"].push_back(
        {{"point", project.graph->points[i].id}, {"root", arrivals[i].root}, {"time", arrivals[i].time}});
  }
  Json exports = Json::object();
  for (const WriterKind& kind : writerKinds())
    exports[std::string(kind.name)] = exportBytes(kind, project, options.fps);
  output["bytes"] = {{"field", sizes.field},
                     {"fps", options.fps},
                     {"npyPerSecond", sizes.npyPerSecond},
                     {"flowMapPerSecond", sizes.flowMapPerSecond},
                     {"exportsPerSecond", std::move(exports)}};
  if (project.grass->kind == GrassKind::Shell) output["bytes"]["shellTextures"] = sizes.shellTextures;
  printJson(output);
}

void printArrivals(const Project& project, const std::vector<Arrival>& arrivals) {
  constexpr std::size_t kMostRows = 20;
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < arrivals.size(); ++i) {
    if (arrivals[i].root != 0) order.push_back(i);
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return arrivals[i].time; });
  if (!order.empty()) std::printf("arrival of the signal\n");
  for (std::size_t row = 0; row < std::min(order.size(), kMostRows); ++row) {
    const std::size_t i = order[row];
    std::printf("  %8s s  point %s, from root %u\n", fixed(arrivals[i].time, 2).c_str(),
                label(project.graph->points[i]).c_str(), arrivals[i].root);
  }
  if (order.size() > kMostRows) {
    std::printf("  ... and %zu more, the last at %s s\n", order.size() - kMostRows,
                fixed(arrivals[order.back()].time, 2).c_str());
  }
}

void printInfoText(const Options& options, const Project& project, const std::vector<Id>& roots,
                   const std::vector<Arrival>& arrivals) {
  const FieldSettings& field = *project.field;
  const Sizes sizes = sizesOf(project, options.fps);
  const glm::vec2 cell = field.size / glm::vec2(field.resolution);
  std::printf("%s: %s\n", printable(options.file).c_str(), printable(project.name).c_str());
  std::printf("field      %s x %s m around (%s, %s), %d x %d cells of %s x %s m\n", metres(field.size.x).c_str(),
              metres(field.size.y).c_str(), metres(field.centre.x).c_str(), metres(field.centre.y).c_str(),
              field.resolution.x, field.resolution.y, metres(cell.x).c_str(), metres(cell.y).c_str());
  std::printf("graph      %s, %s, %s, %s\n", counted(project.graph->points.size(), "point").c_str(),
              counted(project.graph->arrows.size(), "arrow").c_str(), counted(roots.size(), "root").c_str(),
              counted(project.graph->signals.size(), "signal").c_str());
  if (!project.graph->points.empty()) {
    const Extent extent = extentOf(project.graph->points);
    std::printf("extent     x %s to %s m, z %s to %s m\n", metres(extent.min.x).c_str(), metres(extent.max.x).c_str(),
                metres(extent.min.y).c_str(), metres(extent.max.y).c_str());
  }
  std::printf("others     %s, %s, %s, %s, %s, %s, %s\n", counted(project.obstacles->size(), "obstacle").c_str(),
              counted(project.species->size(), "species", "species").c_str(),
              counted(project.colliders->size(), "collider").c_str(),
              counted(project.surfaces->size(), "surface").c_str(), counted(project.rotors->size(), "rotor").c_str(),
              counted(project.probes->size(), "probe").c_str(), counted(project.cameras->size(), "camera").c_str());
  std::printf("ambient    %s m/s towards %s deg\n", metres(project.ambient->speed).c_str(),
              metres(project.ambient->direction).c_str());
  printTerrain(*project.terrain);
  std::printf("grass      %s, %s\n", std::string(choiceName(*project.grass, "kind")).c_str(),
              counted(static_cast<std::uint64_t>(sizes.blades), "blade").c_str());
  if (project.grass->kind == GrassKind::Shell) {
    std::printf("           %s, %s of textures that repeat every %s m\n",
                counted(static_cast<std::uint64_t>(project.shell->shells), "shell").c_str(),
                megabytes(static_cast<double>(sizes.shellTextures)).c_str(), metres(project.shell->tile).c_str());
  }
  printSurfaces(*project.surfaces);
  printRotors(*project.rotors);
  for (const Id root : roots) {
    std::printf("root       %s plays %s\n", label(*findPoint(*project.graph, root)).c_str(),
                std::string(signalName(project, root)).c_str());
  }
  printArrivals(project, arrivals);
  std::printf("memory     %s for the velocity field\n", megabytes(sizes.field).c_str());
  std::printf("export     a second of %s frames at full resolution, in each format at most or about:\n",
              plain(options.fps).c_str());
  for (const WriterKind& kind : writerKinds()) {
    std::printf("  %-14s %10s\n", std::string(kind.name).c_str(),
                megabytes(static_cast<double>(exportBytes(kind, project, options.fps))).c_str());
  }
}

int showInfo(const Options& options) {
  const Result<Project> project = loadWithWarnings(options.file, options.outside);
  if (!project) return reportError(project.error(), options);
  const GraphEvaluator evaluator(*project->graph);
  const std::vector<Id> roots = findRoots(*project->graph);
  (options.json ? printInfoJson : printInfoText)(options, *project, roots, evaluator.arrivals());
  return kExitDone;
}

}  // namespace

VerbAction makeInfoVerb(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("file", options->file, "Project file (NAME.wind.json)")->required();
  app.add_option("--fps", options->fps, "Frames a second to count the exports with")
      ->check(numberFrom(0.1, 1000.0))
      ->capture_default_str();
  addProjectOptions(app, *options);
  addCommonOptions(app, *options);
  app.footer("Arrival times are those at which the signal of a root reaches a point, in seconds after its onset.");
  return [options] { return showInfo(*options); };
}

}  // namespace windloom::cli
