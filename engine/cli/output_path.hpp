#pragma once
// Names of files that verbs write.

#include <filesystem>

#include "engine/core/result.hpp"

namespace windloom::cli {

/// BadInput where the folder that `file` is to lie in doesn't exist; it isn't made.
Status requireFolderOf(const std::filesystem::path& file);

}  // namespace windloom::cli
