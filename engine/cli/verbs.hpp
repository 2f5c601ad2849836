#pragma once
// The verbs of the command line.
//
// To add one: write engine/cli/verb_NAME.cpp with a function
//     VerbAction makeNameVerb(CLI::App& app);
// that adds the verb's options to `app` and returns what it does; declare and list it in verbs.cpp and
// add the file to CMakeLists.txt. Options live in a struct that the action shares:
//
//     struct Options : CommonOptions { std::string file; };
//     VerbAction makeNameVerb(CLI::App& app) {
//       auto options = std::make_shared<Options>();
//       addCommonOptions(app, *options);
//       app.add_option("file", options->file, "Project to read")->required();
//       return [options] { return run(*options); };
//     }
//
// The action returns the exit status; expected failures go through reportError (common.hpp).

#include <functional>
#include <span>
#include <string>

namespace CLI {
class App;
}

namespace windloom::cli {

using VerbAction = std::function<int()>;

enum class VerbKind {
  Public,
  Developer,  ///< not listed in --help
};

struct Verb {
  std::string name;
  std::string summary;  ///< one line of --help
  VerbAction (*make)(CLI::App& app);
  VerbKind kind = VerbKind::Public;
};

/// All verbs in the order of --help.
std::span<const Verb> verbs();

}  // namespace windloom::cli
