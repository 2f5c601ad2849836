#pragma once
// docs/limits.md from the constants themselves.

#include <string>

namespace windloom::cli {

/// The page. A test compares the file in docs with it.
std::string limitsMarkdown();

}  // namespace windloom::cli
