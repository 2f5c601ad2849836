#pragma once
// The last step of a bake: its files go to where they were asked for, all of them or none.
//
// A folder without a manifest is no bake, one with it is whole. So the older manifest goes first and the new one comes
// last, and in between the older bake's files wait in the work folder: what fails or is killed on the way can be taken
// back. docs/bake.md tells users.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/result.hpp"

namespace windloom {

struct Publication {
  std::filesystem::path folder;    ///< where the bake goes
  std::filesystem::path work;      ///< inside it: has manifest.json, and the extras
  std::filesystem::path frames;    ///< has the frames: `work`, or the folder of the parts
  std::vector<std::string> files;  ///< plain names, the frames first, without manifest.json
  std::size_t frameFiles = 0;
};

/// Moves everything out; all of it must be on the disk (syncFiles) and the folder locked. Files of the older bake that
/// the new one doesn't have go, unless somebody changed them. The bytes that were moved. Fails with Machine and
/// BadInput, the older bake as it was.
Result<std::uint64_t> publish(const Publication& publication);

/// Clears up after bakes that were killed: their work folders, after an unfinished publish() was taken back, and the
/// parts of a bake that is there as a whole. Work folders of running bakes are left alone, and all of it where another
/// program has the folder locked.
void clearLeftBakes(const std::filesystem::path& folder);

}  // namespace windloom
