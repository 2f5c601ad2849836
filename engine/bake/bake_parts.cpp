#include "engine/bake/bake_parts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/bake/bake.hpp"
#include "engine/bake/manifest.hpp"
#include "engine/bake/work_folder.hpp"
#include "engine/core/file.hpp"
#include "engine/io/json_document.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kNote = "part-";

/// A whole number of 0 to kMaxBakeFrames - 1; -1 for anything else.
int frameIn(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end() || !found->is_number()) return -1;
  const double frame = found->get<double>();
  return frame >= 0 && frame < kMaxBakeFrames && frame == std::floor(frame) ? static_cast<int>(frame) : -1;
}

/// A speed; a note without a sensible one has a negative one.
float speedIn(const Json& note, const char* key) {
  const auto found = note.find(key);
  const float speed = found != note.end() && found->is_number() ? found->get<float>() : -1.0f;
  return std::isfinite(speed) ? speed : -1.0f;
}

bool isTiles(const Json& tiles) {
  return tiles.is_array() && tiles.size() == 2 && std::ranges::all_of(tiles, [](const Json& n) {
           return n.is_number_integer() && n >= 1 && n <= kMaxBakeFrames;
         });
}

/// Settings for an engine's importer, which become lines of a text: KEY=VALUE.
bool isImport(const Json& settings) {
  if (!settings.is_object()) return false;
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyz0123456789_/";
  for (const auto& [key, value] : settings.items()) {
    if (key.empty() || key.find_first_not_of(allowed) != key.npos || value.is_structured()) return false;
  }
  return true;
}

/// What is taken from an entry later on; its file lies in the parts' own folder, never elsewhere.
bool isEntry(const Json& entry) {
  if (!entry.is_object()) return false;
  // Each is a plain word, so that none means something in the texts that are made of them.
  for (const char* key : {"path", "role", "encoding"}) {
    const auto text = entry.find(key);
    if (text == entry.end() || !text->is_string() || !isPlainName(text->get_ref<const std::string&>())) return false;
  }
  const auto holds = [&](const char* key, auto test) { return !entry.contains(key) || test(entry[key]); };
  return holds("frame", [&](const Json&) { return frameIn(entry, "frame") >= 0; }) && holds("tiles", isTiles) &&
         holds("import", isImport) && holds("strength", [](const Json& value) { return value.is_number(); });
}

/// Nothing where it is not a note of ours: its frames count as missing.
std::optional<BakePart> partFrom(const Json& note) {
  if (!note.is_object() || !note.contains("groups") || !note["groups"].is_array()) return std::nullopt;
  BakePart part;
  part.first = frameIn(note, "first");
  part.last = frameIn(note, "last");
  part.fastest = speedIn(note, "fastest");
  part.seam = {speedIn(note, "seam"), speedIn(note, "step")};
  if (part.first < 0 || part.last < part.first || part.fastest < 0 || part.seam.seam < 0 || part.seam.step < 0)
    return std::nullopt;
  for (const Json& group : note["groups"]) {
    if (!group.is_array() || !std::ranges::all_of(group, isEntry)) return std::nullopt;
    part.groups.emplace_back(group.begin(), group.end());
  }
  return part;
}

}  // namespace

fs::path partsFolder(const fs::path& folder, const std::string& key) {
  return folder / (".parts-" + key);
}

Status writePart(const fs::path& parts, const BakePart& part) {
  const Json note = {{"first", part.first},    {"last", part.last},      {"fastest", part.fastest},
                     {"seam", part.seam.seam}, {"step", part.seam.step}, {"groups", part.groups}};
  const std::string name = std::string(kNote) + std::to_string(part.first) + "-" + std::to_string(part.last) + ".json";
  return writeFileAtomically(parts / name, note.dump());
}

/// A part whose files were lost, or moved out by a bake that was killed then, counts as missing. Links don't count.
bool hasAllFiles(const fs::path& parts, const BakePart& part) {
  std::error_code ec;
  for (const std::vector<Json>& group : part.groups) {
    for (const Json& entry : group) {
      const fs::path file = parts / entry["path"].get_ref<const std::string&>();
      if (!fs::is_regular_file(fs::symlink_status(file, ec))) return false;
    }
  }
  return true;
}

std::vector<BakePart> readParts(const fs::path& parts) {
  std::vector<BakePart> found;
  std::error_code ec;
  if (!isRealFolder(parts)) return found;
  for (const fs::directory_entry& entry : fs::directory_iterator(parts, ec)) {
    if (!entry.path().filename().string().starts_with(kNote)) continue;
    const Result<std::string> text = readFile(entry.path(), kMaxManifestBytes);
    if (!text) continue;
    const Result<Json> note = parseJsonDocument(*text, entry.path().string());
    std::optional<BakePart> part = note ? partFrom(*note) : std::nullopt;
    if (part && hasAllFiles(parts, *part)) found.push_back(std::move(*part));
  }
  std::ranges::sort(found, {}, [](const BakePart& part) { return std::pair(part.first, part.last); });
  return found;
}

std::vector<std::pair<int, int>> missingFrames(const std::vector<BakePart>& parts, int frames) {
  std::vector<std::pair<int, int>> missing;
  int next = 0;
  for (const BakePart& part : parts) {
    if (part.first > next) missing.emplace_back(next, part.first - 1);
    next = std::max(next, part.last + 1);
  }
  if (next < frames) missing.emplace_back(next, frames - 1);
  return missing;
}

std::optional<BakePart> joinParts(std::vector<BakePart> parts, int frames) {
  BakePart whole;
  whole.last = frames - 1;
  int next = 0;  // first frame that is still missing
  for (BakePart& part : parts) {
    if (part.first > next) return std::nullopt;
    if (part.last < next) continue;
    whole.fastest = std::max(whole.fastest, part.fastest);
    whole.seam.seam = std::max(whole.seam.seam, part.seam.seam);
    whole.seam.step = std::max(whole.seam.step, part.seam.step);
    whole.groups.resize(std::max(whole.groups.size(), part.groups.size()));
    for (std::size_t g = 0; g < part.groups.size(); ++g) {
      for (Json& entry : part.groups[g]) {
        if (entry.value("frame", 0) >= next) whole.groups[g].push_back(std::move(entry));
      }
    }
    next = part.last + 1;
  }
  if (next < frames) return std::nullopt;
  return whole;
}

}  // namespace windloom
