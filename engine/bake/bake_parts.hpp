#pragma once
// A bake that is split into ranges of frames. Each part leaves its files in a hidden folder of the plan, ".parts-KEY",
// with a note; the part that finds the plan complete moves everything out and writes the manifest of the whole.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/bake/seam.hpp"
#include "engine/core/result.hpp"

namespace windloom {

struct BakePart {
  int first = 0, last = 0;
  float fastest = 0;  ///< m/s, of its frames
  SeamReport seam;
  /// Manifest entries in the order of formats and tracks: groups[g] is the same format and track in every part.
  std::vector<std::vector<nlohmann::ordered_json>> groups;
};

/// The folder of the parts of a plan; `key` names the plan (a checksum of all that decides about the frames).
std::filesystem::path partsFolder(const std::filesystem::path& folder, const std::string& key);

/// Writes the note of a part beside its files. Fails with Machine.
Status writePart(const std::filesystem::path& parts, const BakePart& part);

/// All parts that are noted there, by first frame. A note that can't be read, or whose files aren't all there,
/// is left out.
std::vector<BakePart> readParts(const std::filesystem::path& parts);

/// Ranges of frames (first, last) that none of the parts, sorted by first frame, has.
std::vector<std::pair<int, int>> missingFrames(const std::vector<BakePart>& parts, int frames);

/// The parts as one, with every frame once, where they hold all of 0 to frames - 1; else nothing.
std::optional<BakePart> joinParts(std::vector<BakePart> parts, int frames);

}  // namespace windloom
