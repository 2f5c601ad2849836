#include "engine/cli/verbs.hpp"

#include <array>

namespace windloom::cli {

VerbAction makeValidateVerb(CLI::App& app);

std::span<const Verb> verbs() {
  static const std::array kVerbs{
      Verb{"validate", "Checks project files and lists all problems", makeValidateVerb},
  };
  return kVerbs;
}

}  // namespace windloom::cli
