#pragma once
// Whole files in and out. Writing is atomic: a reader, a crash or a full disk never meets a torn file.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.hpp"

namespace windloom {

/// The bytes of a regular file. Fails with Machine for I/O trouble and with BadInput where the path is missing, is a
/// folder, pipe, device or socket (none is waited for), or is larger than `limitBytes`, seen before memory is taken.
Result<std::string> readFile(const std::filesystem::path& path, std::uint64_t limitBytes = 256ull << 20);

/// The same, handed on in pieces, for files of any size.
Status readFileInPieces(const std::filesystem::path& path, const std::function<void(std::string_view)>& use,
                        std::uint64_t limitBytes = UINT64_MAX);

enum class Backup { None, KeepOne };

/// Access rights of what only its owner may look into.
inline constexpr unsigned kOwnersFile = 0600, kOwnersFolder = 0700;

/// Writes `bytes` to a temporary file in the same folder, syncs it, and renames it over `path`. With
/// KeepOne the old file is first kept as "PATH.bak". Without `mode` the access rights of an older file are kept, and
/// a new one's are newFileMode(). On failure (Machine) the old file is untouched and no temporary file stays.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes, Backup backup = Backup::None,
                           std::optional<unsigned> mode = {});

/// Access rights of new files, as the process's umask wants them. The umask can only be read by changing it for a
/// moment, so it is read once: threads that write files at the same time must not meet that moment.
unsigned newFileMode();

/// Makes a folder and its parents, those that aren't there with the access rights `mode` less the umask. Fails with
/// Machine.
Status makeFolder(const std::filesystem::path& path, unsigned mode = 0777);

/// Where the program's files lie: in $WINDLOOM_DATA if set, else in ../share/windloom seen from the program's own
/// folder (links to a program are followed), which a build folder has as well. `name` is "shaders", "projects" or
/// "icons". Fails with Machine, naming the folders that were tried.
Result<std::filesystem::path> findDataFolder(std::string_view name);

}  // namespace windloom
