#include "engine/cli/common.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "engine/cli/project_option.hpp"
#include "engine/core/text.hpp"

namespace windloom::cli {

void addCommonOptions(CLI::App& app, CommonOptions& options) {
  app.add_flag("--json", options.json, "Write one JSON object to standard output");
  addBackendOption(app, options);
}

void addBackendOption(CLI::App& app, CommonOptions& options) {
  const auto setBackend = [&options](const std::string& name) {
    if (name != "auto" && name != "gpu" && name != "cpu") {
      throw CLI::ValidationError("--backend", "found '" + name + "', expected auto, gpu or cpu");
    }
    options.backend = name == "gpu" ? Backend::Gpu : (name == "cpu" ? Backend::Cpu : Backend::Auto);
  };
  app.add_option_function<std::string>("--backend", setBackend, "Where the wind is computed (default auto)")
      ->type_name("auto|gpu|cpu");
}

int exitStatus(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::BadInput:
      return kExitBadInput;
    case ErrorKind::Usage:
      return kExitUsage;
    case ErrorKind::Machine:
      break;
  }
  return kExitMachine;
}

int reportError(const Error& error, const CommonOptions& options) {
  for (const Problem& problem : error.problems) std::fprintf(stderr, "windloom: %s\n", problem.text().c_str());
  if (options.json) printJson({{"ok", false}, {"errors", problemsJson(error.problems)}});
  return exitStatus(error.kind);
}

Result<Project> loadWithWarnings(const std::string& file) {
  return loadWithWarnings(file, OutsideFiles::Refuse);
}

Json problemsJson(const std::vector<Problem>& problems) {
  Json list = Json::array();
  for (const Problem& problem : problems) {
    list.push_back({{"file", problem.file}, {"pointer", problem.pointer}, {"message", problem.message}});
  }
  return list;
}

Json jsonNumber(float value) {
  return *parseNumber(shortest(value));
}

std::optional<glm::ivec2> parsePair(const std::string& text, int most) {
  const auto cross = text.find_first_of("xX");
  if (cross == std::string::npos) return std::nullopt;
  const auto width = parseNumber(text.substr(0, cross)), height = parseNumber(text.substr(cross + 1));
  const auto sensible = [most](const std::optional<double>& side) {
    return side && *side >= 8 && *side <= most && *side == std::floor(*side);
  };
  if (!sensible(width) || !sensible(height)) return std::nullopt;
  return glm::ivec2(*width, *height);
}

Error pairExpected(const std::string& option, const std::string& found, int most, const std::string& of) {
  return makeError(ErrorKind::Usage,
                   option + ": found '" + found + "', expected WxH of 8 to " + std::to_string(most) + " " + of);
}

void printJson(const Json& object) {
  // JSON lets DEL and C1 stand as they are; terminals don't. Elsewhere than in texts there are none.
  std::string text;
  const std::string dumped = object.dump(2, ' ', false, Json::error_handler_t::replace);
  for (std::size_t i = 0; i < dumped.size(); ++i) {
    const bool c1 = dumped[i] == '\xC2' && static_cast<unsigned char>(dumped[i + 1]) < 0xA0;
    if (c1) ++i;
    if (c1 || dumped[i] == 0x7F) {
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\u%04x", unsigned{static_cast<unsigned char>(dumped[i])});
      text += escaped;
    } else {
      text += dumped[i];
    }
  }
  std::printf("%s\n", text.c_str());
}

}  // namespace windloom::cli
