#include "engine/bake/manifest.hpp"

#include <algorithm>
#include <unordered_set>

#include "engine/bake/response.hpp"
#include "engine/bake/target_frame.hpp"
#include "engine/core/file.hpp"
#include "engine/core/text.hpp"
#include "engine/io/json_document.hpp"
#include "engine/io/sha256.hpp"

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

Json solverOf(const Project& project, Backend backend) {
  const SolverSettings& solver = *project.solver;
  const bool multigrid = solver.pressure == Pressure::Multigrid;
  return {{"backend", backend == Backend::Gpu ? "gpu" : "cpu"},
          {"advection", solver.advection == Advection::MacCormack ? "maccormack" : "semi-lagrangian"},
          {"pressure", multigrid ? "multigrid" : "jacobi"},
          {"resolution", {project.field->resolution.x, project.field->resolution.y}},
          {"timeStep", plain(project.field->timeStep)}};
}

/// Whether samples are codes of a full scale.
bool isCoded(std::string_view encoding) {
  return encoding == "unorm8" || encoding == "unorm16" || encoding == "bc5";
}

Json responseOf() {
  Json classes = Json::array();
  for (const PlantClass& plant : plantClasses()) {
    classes.push_back({{"track", plant.name},
                       {"bend", plain(plant.bend)},
                       {"frequency", plain(plant.frequency)},
                       {"damping", plain(plant.damping)}});
  }
  return {{"units", "rad"}, {"full_scale", plain(kBendFullScale)}, {"classes", std::move(classes)}};
}

/// The text under a key of an object; empty where there is none.
std::string textOf(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

Result<Json> manifestEntry(const BakedFile& file, const BakeHeader& header, const std::filesystem::path& folder) {
  const Result<std::string> digest = sha256OfFile(folder / file.path);
  if (!digest) return digest.error();
  Json entry = {{"path", file.path}, {"sha256", *digest}, {"role", file.role}, {"encoding", file.encoding}};
  if (file.role == "field" || file.role == "flow" || file.role == "volume") entry["track"] = header.track.name;
  if (file.role == "field") {
    const PresetRules& own = rulesOf(Preset::Generic);
    entry["units"] = header.track.quantity == Quantity::Wind ? own.speedUnit : "rad";
    entry["frame"] = frameOf(own);
    entry["bounds"] = boundsOf(own, header.grid);
    entry["rowOrder"] = rowOrderOf(own);
  } else if (isCoded(file.encoding)) {
    const TargetFrame target(header);
    entry["full_scale"] = plain(target.fullScale());
    if (file.role == "flow") entry["zero_code"] = file.encoding == "unorm16" ? 32768 : 128;
    entry["units"] = target.unit();
  }
  for (const auto& [key, value] : file.details.items()) entry[key] = value;
  return entry;
}

std::string manifestText(const ManifestFacts& facts, const Project& project, Backend backend,
                         std::span<const Json> files) {
  const BakeHeader& header = facts.header;
  const PresetRules& rules = rulesOf(header.preset);
  const auto holds = [&](std::string_view encoding) {
    // Volumes say themselves how they are decoded.
    return std::any_of(files.begin(), files.end(),
                       [&](const Json& f) { return f["role"] != "volume" && f["encoding"] == encoding; });
  };
  const bool eight = holds("unorm8") || holds("bc5"), sixteen = holds("unorm16");
  const TargetFrame target(header);
  const float fastest = target.unit() == "uv/s" ? header.fastest / std::min(header.grid.size.x, header.grid.size.y)
                                                : header.fastest * rules.unitsPerMetre;
  Json time = {{"fps", header.fps},
               {"frames", header.frames},
               {"start", header.start},
               {"loop", header.loop},
               {"crossfade", header.crossfade}};
  if (header.crossfade > 0)
    time["seam"] = {{"change", plain(facts.seam.seam)}, {"largestStep", plain(facts.seam.step)}, {"units", "m/s"}};
  Json manifest = {{"format", "windpack"},
                   {"version", 1},
                   {"generator", "windloom " WINDLOOM_VERSION},
                   {"name", project.name},
                   {"preset", rules.name},
                   {"units", target.unit()},
                   {"lengthUnit", rules.lengthUnit},
                   {"frame", frameOf(rules)},
                   {"bounds", boundsOf(rules, header.grid)},
                   {"grid", {header.grid.resolution.x, header.grid.resolution.y}},
                   {"cell", pair(header.grid.cellSize * rules.unitsPerMetre)},
                   {"time", std::move(time)},
                   {"vmax", plain(eight || sixteen ? target.fullScale() : fastest)}};
  if (eight || sixteen) {
    manifest["encoding"] = holds("unorm8") ? "unorm8" : eight ? "bc5" : "unorm16";
    manifest["zero_code"] = eight ? 128 : 32768;
    manifest["decode"] = eight ? "(code - 128) / 127 * vmax" : "(code - 32768) / 32767 * vmax";
    manifest["channels"] = {{"r", "velocity along " + std::string(rules.axes[0])},
                            {"g", "velocity along " + std::string(rules.axes[1])},
                            {"b", eight ? "speed, code / 255 * vmax" : "speed, code / 65535 * vmax"},
                            {"a", eight ? "255" : "65535"}};
  } else if (!files.empty()) {
    manifest["encoding"] = files.front()["encoding"];
  }
  manifest["space"] = header.space == FlowSpace::World ? "world" : "uv";
  manifest["rowOrder"] = rowOrderOf(rules);
  manifest["vOrigin"] = rules.vUpwards ? "bottom" : "top";
  manifest["periodic"] = {header.periodicX, header.periodicZ};
  manifest["profile"] = {{"law", "ln(1 + height / roughness) / ln(1 + reference / roughness)"},
                         {"reference", plain(header.profile.reference)},
                         {"roughness", plain(header.profile.roughness)},
                         {"lengthUnit", "m"}};
  if (facts.response) manifest["response"] = responseOf();
  if (facts.card) manifest["card"] = true;
  if (!facts.plan.empty()) manifest["plan"] = facts.plan;
  manifest["files"] = files;
  manifest["seed"] = project.solver->seed;
  manifest["solver"] = solverOf(project, backend);
  // A project's name may hold bytes that aren't UTF-8; they are replaced rather than thrown about.
  return manifest.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

bool isPlainName(std::string_view name) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_";
  return !name.empty() && name.front() != '.' && name.size() <= 255 && name.find_first_not_of(allowed) == name.npos;
}

std::string planOfManifest(const std::filesystem::path& folder) {
  const Result<std::string> text = readFile(folder / "manifest.json", kMaxManifestBytes);
  if (!text) return {};
  const Result<Json> manifest = parseJsonDocument(*text, {});
  const std::string plan = manifest && manifest->is_object() ? textOf(*manifest, "plan") : std::string();
  // It becomes part of the name of a folder that is removed.
  const bool digits = plan.size() == kPlanDigits && plan.find_first_not_of("0123456789abcdef") == plan.npos;
  return digits ? plan : std::string();
}

Result<std::vector<ListedFile>> filesOfManifest(const std::filesystem::path& folder) {
  std::vector<ListedFile> files;
  std::error_code ignored;
  const std::filesystem::path path = folder / "manifest.json";
  if (!std::filesystem::exists(path, ignored)) return files;
  const Result<std::string> text = readFile(path, kMaxManifestBytes);
  if (!text) return text.error();
  const Result<Json> parsed = parseJsonDocument(*text, path.string());
  const Json manifest = parsed ? *parsed : Json();
  if (!manifest.is_object() || textOf(manifest, "format") != "windpack" || !manifest.contains("files")) {
    return makeError(ErrorKind::BadInput, path.string(), {},
                     "is not the manifest of a bake; bake into another folder or move it away");
  }
  std::unordered_set<std::string> names;
  for (const Json& entry : manifest["files"]) {
    if (!entry.is_object()) continue;
    if (std::string name = textOf(entry, "path"); isPlainName(name) && names.insert(name).second)
      files.push_back({std::move(name), textOf(entry, "sha256")});
  }
  return files;
}

}  // namespace windloom
