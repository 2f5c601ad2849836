#pragma once
// The whole command line: which verb, with which options. Nothing is done yet, so that it can be tested by itself.

#include <optional>

#include "engine/cli/verbs.hpp"

namespace windloom::cli {

/// What is to be done. Nothing where the program is to end at once with `exitStatus`: help, version, wrong usage (2),
/// which are told.
std::optional<VerbAction> parseCommandLine(int argc, const char* const* argv, int& exitStatus);

}  // namespace windloom::cli
