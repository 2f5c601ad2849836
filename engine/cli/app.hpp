#pragma once
// The whole command line in one place: for running a verb, and for writing down what there is.

#include <memory>

#include "engine/cli/verbs.hpp"

namespace windloom::cli {

/// "0.1.0"
const char* programVersion();

/// All verbs with their options. Parsing sets `chosen`, which must outlive the app, to what the verb does.
std::unique_ptr<CLI::App> makeApp(VerbAction& chosen);

}  // namespace windloom::cli
