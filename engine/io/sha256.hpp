#pragma once
// SHA-256 (FIPS 180-4), so that a game's pipeline can tell whether a baked file arrived whole.

#include <filesystem>
#include <string>
#include <string_view>

#include "engine/core/result.hpp"

namespace windloom {

/// The digest as 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

/// Of a whole file, read piece by piece. Fails with Machine; pipes and devices are not waited for.
Result<std::string> sha256OfFile(const std::filesystem::path& path);

}  // namespace windloom
