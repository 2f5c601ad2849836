#include "engine/bake/bake_parts.hpp"

#include <algorithm>
#include <optional>

#include "engine/bake/bake.hpp"
#include "engine/bake/manifest.hpp"
#include "engine/core/file.hpp"
#include "engine/io/json_document.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kNote = "part-";

/// Names and counts come from a file that anyone may have written.
bool isLegal(const BakePart& part) {
  if (part.first < 0 || part.last < part.first || part.last >= kMaxBakeFrames) return false;
  return std::ranges::all_of(part.groups, [](const std::vector<Json>& group) {
    return std::ranges::all_of(group, [](const Json& entry) {
      if (!entry.is_object()) return false;
      const auto path = entry.find("path"), frame = entry.find("frame");
      if (path == entry.end() || !path->is_string() || !isPlainName(path->get_ref<const std::string&>())) return false;
      return frame == entry.end() || frame->is_number_integer();
    });
  });
}

BakePart partFrom(const Json& note) {
  BakePart part;
  part.first = note.at("first");
  part.last = note.at("last");
  part.fastest = note.at("fastest");
  part.seam = {note.at("seam"), note.at("step")};
  part.groups = note.at("groups");
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

/// A part whose files were lost, or moved out by a bake that was killed then, counts as missing.
bool hasAllFiles(const fs::path& parts, const BakePart& part) {
  std::error_code ec;
  for (const std::vector<Json>& group : part.groups) {
    for (const Json& entry : group) {
      if (!fs::exists(parts / entry.value("path", std::string("?")), ec)) return false;
    }
  }
  return true;
}

std::vector<BakePart> readParts(const fs::path& parts) {
  std::vector<BakePart> found;
  std::error_code ec;
  for (const fs::directory_entry& entry : fs::directory_iterator(parts, ec)) {
    if (!entry.path().filename().string().starts_with(kNote)) continue;
    const Result<std::string> text = readFile(entry.path(), kMaxManifestBytes);
    const Result<Json> note = text ? parseJsonDocument(*text, entry.path().string()) : text.error();
    if (!note) continue;
    try {
      BakePart part = partFrom(*note);
      if (isLegal(part) && hasAllFiles(parts, part)) found.push_back(std::move(part));
    } catch (const Json::exception&) {
      continue;  // not a note of ours: its frames count as missing
    }
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
