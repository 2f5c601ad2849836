#pragma once
// Files that a project is read from but not saved to.

#include <filesystem>
#include <string>

namespace windloom::editor {

/// Why the editor saves a project elsewhere than in this file, as one sentence for the user: it is one of the installed
/// samples, would lie among them, or its folder may not be written to. Empty where it may be saved. Asks the file system.
std::string whyKept(const std::filesystem::path& file);

}  // namespace windloom::editor
