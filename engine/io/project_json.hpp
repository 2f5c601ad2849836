#pragma once
// The project file, NAME.wind.json. Shape: docs/project.schema.json; parameters: docs/parameters.md.
//
// Reading is strict about what it knows and careful with what it doesn't: every error is collected with
// its place, unknown keys are kept as they are and written back, and nothing is dropped silently.
// Writing is canonical: fixed order of keys, shortest numbers, one point, arrow, signal, obstacle, species,
// collider, surface, rotor, probe or camera a line; in these records, and in the terrain, values that equal their
// default are left out, and so are maps of the grass that there aren't.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/io/file_access.hpp"
#include "engine/model/project.hpp"

namespace windloom {

inline constexpr std::string_view kProjectFormat = "windloom-project";
inline constexpr std::uint64_t kMaxProjectBytes = 64ull << 20;

struct LoadedProject {
  Project project;
  std::vector<Problem> warnings;  ///< unknown keys, with their places; an older version that was brought up to date
  /// Files that the project names and that are missing or broken. The project is whole all the same and saves as
  /// it was; the ground is flat.
  std::vector<Problem> missing;
  bool outsideRefused = false;  ///< some of them lie outside the project's folder, and that was not allowed
};

/// Fails with BadInput, all problems collected, or with Machine where the file can't be read or there is not enough
/// memory. Reads the files that it names, too: those outside the folder of `path` only where that is allowed.
Result<LoadedProject> loadProject(const std::filesystem::path& path, OutsideFiles outside = OutsideFiles::Refuse);

/// The same from text, without the terrain's file; `fileName` only goes into messages.
Result<LoadedProject> parseProject(std::string_view text, const std::string& fileName);

/// The file's bytes for a valid project. writeProject(parseProject(b)) gives b again for any b that
/// writeProject made.
std::string writeProject(const Project& project);

/// Writes atomically and keeps one PATH.bak. Fails with BadInput where the project isn't valid (NaN
/// included), with Machine for I/O trouble; the old file is then untouched.
Status saveProject(const Project& project, const std::filesystem::path& path);

}  // namespace windloom
