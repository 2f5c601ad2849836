#pragma once
// manifest.json: what a game or a person needs to know to use the files beside it. docs/bake.md describes each key,
// docs/manifest.schema.json is its schema.

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bake/frame_writer.hpp"
#include "engine/bake/seam.hpp"
#include "engine/model/project.hpp"

namespace windloom {

/// A file's line in the manifest: path, checksum, role, encoding, and for files in our own frame what that is. Fails
/// with Machine where the file in `folder` can't be read.
Result<nlohmann::ordered_json> manifestEntry(const BakedFile& file, const BakeHeader& header,
                                             const std::filesystem::path& folder);

/// What the manifest tells beside the files.
struct ManifestFacts {
  BakeHeader header;  ///< of the wind
  SeamReport seam;    ///< of a loop
  bool response = false;
  bool card = false;  ///< the wind is the calibration card
  std::string plan;   ///< names what was recorded and how: the same in all parts of one bake
};

/// The text. `backend` is the one that ran.
std::string manifestText(const ManifestFacts& facts, const Project& project, Backend backend,
                         std::span<const nlohmann::ordered_json> files);

/// A name as bakes give to files: letters, digits, '.', '-' and '_', at most 255, not hidden; never a path. Only such
/// are taken from files that are read back, as what comes with a folder may be anybody's.
bool isPlainName(std::string_view name);

/// Of a manifest, and of the note of a part, that is read back: 100 000 frames in ten formats are about 200 MB.
inline constexpr std::uint64_t kMaxManifestBytes = 256ull << 20;

/// Names the plan of a bake: lower-case hexadecimal digits.
inline constexpr std::size_t kPlanDigits = 16;

/// The plan of the bake in `folder`; empty where there is none, or something else in its place.
std::string planOfManifest(const std::filesystem::path& folder);

struct ListedFile {
  std::string path, sha256;
};

/// The files that the manifest in `folder` lists, each once; empty where there is none. Only plain names. Fails with
/// BadInput where a manifest.json lies there that isn't of a bake.
Result<std::vector<ListedFile>> filesOfManifest(const std::filesystem::path& folder);

}  // namespace windloom
