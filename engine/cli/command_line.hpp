#pragma once
// The whole command line in one place: for running a verb, for writing down what there is, and for tests. Nothing is
// done while it is read.

#include <memory>
#include <optional>

#include "engine/cli/verbs.hpp"

namespace windloom::cli {

/// "0.1.0"
const char* programVersion();

/// All verbs with their options. Parsing sets `chosen`, which must outlive the app, to what the verb does.
std::unique_ptr<CLI::App> makeApp(VerbAction& chosen);

/// What is to be done. Nothing where the program is to end at once with `exitStatus`: help, version, wrong usage (2),
/// which are told.
std::optional<VerbAction> parseCommandLine(int argc, const char* const* argv, int& exitStatus);

}  // namespace windloom::cli
