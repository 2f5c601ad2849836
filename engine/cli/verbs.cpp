#include "engine/cli/verbs.hpp"

#include <CLI/CLI.hpp>
#include <array>

namespace windloom::cli {

VerbAction makeNewVerb(CLI::App& app);
VerbAction makeValidateVerb(CLI::App& app);
VerbAction makeInfoVerb(CLI::App& app);
VerbAction makeSampleVerb(CLI::App& app);
VerbAction makeBakeVerb(CLI::App& app);
VerbAction makeRenderVerb(CLI::App& app);
VerbAction makeBenchVerb(CLI::App& app);
VerbAction makeEditVerb(CLI::App& app);
VerbAction makeDocsVerb(CLI::App& app);

std::span<const Verb> verbs() {
  static const std::array kVerbs{
      Verb{"new", "Writes a new project from a template", makeNewVerb},
      Verb{"validate", "Checks project files and lists all problems", makeValidateVerb},
      Verb{"info", "Shows what is in a project and how much memory it needs", makeInfoVerb},
      Verb{"sample", "Tells the wind at places and a moment", makeSampleVerb},
      Verb{"bake", "Records the wind and writes it for games", makeBakeVerb},
      Verb{"render", "Makes pictures of a project at a moment", makeRenderVerb},
      Verb{"bench", "Measures the wind step, grass and loading", makeBenchVerb},
      Verb{"edit", "Starts the editor", makeEditVerb},
      Verb{"docs", "Writes the project file's schema and the list of parameters", makeDocsVerb, VerbKind::Developer},
  };
  return kVerbs;
}

}  // namespace windloom::cli
