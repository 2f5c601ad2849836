#include "engine/bake/manifest.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/file.hpp"
#include "engine/core/text.hpp"

namespace windloom {
namespace {

using Json = nlohmann::ordered_json;

/// A float as the double of its shortest decimal text, so that 0.1f is written as 0.1.
double plain(float value) {
  return parseNumber(shortest(value)).value_or(0.0);
}

Json pair(glm::vec2 value) {
  return Json::array({plain(value.x), plain(value.y)});
}

Json frameOf(const PresetRules& rules) {
  return {{"handedness", rules.handedness}, {"up", rules.up}, {"axes", {rules.axes[0], rules.axes[1]}}};
}

Json boundsOf(const PresetRules& rules, const GridMapping& grid) {
  const PresetBounds bounds = boundsIn(rules, grid.minCorner, grid.size);
  return {{"min", pair(bounds.min)}, {"max", pair(bounds.max)}};
}

std::string_view rowOrderOf(const PresetRules& rules) {
  return rules.firstRowHigh ? "descending" : "ascending";
}

Json fileEntry(const ManifestFile& baked, const BakeHeader& header) {
  Json entry = {{"path", baked.file.path},
                {"sha256", baked.sha256},
                {"role", baked.file.role},
                {"encoding", baked.file.encoding}};
  if (baked.file.role == "field") {
    const PresetRules& own = rulesOf(Preset::Generic);
    entry["units"] = own.speedUnit;
    entry["frame"] = frameOf(own);
    entry["bounds"] = boundsOf(own, header.grid);
    entry["rowOrder"] = rowOrderOf(own);
  }
  return entry;
}

Json solverOf(const Project& project, Backend backend) {
  const SolverSettings& solver = *project.solver;
  const bool multigrid = solver.pressure == Pressure::Multigrid;
  return {{"backend", backend == Backend::Gpu ? "gpu" : "cpu"},
          {"advection", solver.advection == Advection::MacCormack ? "maccormack" : "semi-lagrangian"},
          {"pressure", multigrid ? "multigrid" : "jacobi"},
          {"resolution", {project.field->resolution.x, project.field->resolution.y}},
          {"timeStep", plain(project.field->timeStep)}};
}

bool isPlainName(const std::string& name) {
  return !name.empty() && name != "." && name != ".." && name.find_first_of("/\\") == std::string::npos;
}

}  // namespace

std::string manifestText(const BakeHeader& header, const Project& project, Backend backend,
                         std::span<const ManifestFile> files) {
  const PresetRules& rules = rulesOf(header.preset);
  const auto encoded =
      std::any_of(files.begin(), files.end(), [](const ManifestFile& f) { return f.file.encoding == "unorm8"; });
  const float speed = encoded ? header.speedRange : header.fastest;
  Json manifest = {{"format", "windpack"},
                   {"version", 1},
                   {"generator", "windloom " WINDLOOM_VERSION},
                   {"name", project.name},
                   {"preset", rules.name},
                   {"units", rules.speedUnit},
                   {"lengthUnit", rules.lengthUnit},
                   {"frame", frameOf(rules)},
                   {"bounds", boundsOf(rules, header.grid)},
                   {"grid", {header.grid.resolution.x, header.grid.resolution.y}},
                   {"cell", pair(header.grid.cellSize * rules.unitsPerMetre)},
                   {"time",
                    {{"fps", header.fps},
                     {"frames", header.frames},
                     {"start", header.start},
                     {"loop", header.loop},
                     {"crossfade", header.crossfade}}},
                   {"vmax", plain(speed * rules.unitsPerMetre)}};
  if (encoded) {
    manifest["encoding"] = "unorm8";
    manifest["zero_code"] = 128;
    manifest["decode"] = "(code - 128) / 127 * vmax";
    manifest["channels"] = {{"r", "velocity along " + std::string(rules.axes[0])},
                            {"g", "velocity along " + std::string(rules.axes[1])},
                            {"b", "speed, code / 255 * vmax"},
                            {"a", "255"}};
  } else if (!files.empty()) {
    manifest["encoding"] = files.front().file.encoding;
  }
  manifest["space"] = "world";
  manifest["rowOrder"] = rowOrderOf(rules);
  manifest["periodic"] = {header.periodicX, header.periodicZ};
  Json list = Json::array();
  for (const ManifestFile& file : files) list.push_back(fileEntry(file, header));
  manifest["files"] = std::move(list);
  manifest["seed"] = project.solver->seed;
  manifest["solver"] = solverOf(project, backend);
  // A project's name may hold bytes that aren't UTF-8; they are replaced rather than thrown about.
  return manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::string> filesOfManifest(const std::filesystem::path& folder) {
  const Result<std::string> text = readFile(folder / "manifest.json", 64ull << 20);
  if (!text) return {};
  const Json manifest = Json::parse(*text, nullptr, false);
  if (!manifest.is_object() || manifest.value("format", Json()) != "windpack" || !manifest.contains("files")) return {};
  std::vector<std::string> names;
  for (const Json& entry : manifest["files"]) {
    if (!entry.is_object() || !entry.contains("path") || !entry["path"].is_string()) continue;
    if (auto name = entry["path"].get<std::string>(); isPlainName(name)) names.push_back(std::move(name));
  }
  return names;
}

}  // namespace windloom
