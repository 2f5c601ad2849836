#pragma once
// What all verbs share: options, exit status, messages, and the shape of machine-readable output.
//
// Results go to standard output, everything else to standard error. With --json standard output holds
// exactly one JSON object; it has "ok", and where that is false "errors": [{file, pointer, message}].

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/model/project.hpp"

namespace CLI {
class App;
}

namespace windloom::cli {

using Json = nlohmann::ordered_json;

inline constexpr int kExitDone = 0;
inline constexpr int kExitBadInput = 1;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitMachine = 3;

struct CommonOptions {
  bool json = false;                ///< --json
  Backend backend = Backend::Auto;  ///< --backend
};

/// Adds --json and --backend.
void addCommonOptions(CLI::App& app, CommonOptions& options);
/// Adds --backend alone.
void addBackendOption(CLI::App& app, CommonOptions& options);

int exitStatus(ErrorKind kind);

/// Says what went wrong, on standard error and with --json also on standard output; the exit status.
int reportError(const Error& error, const CommonOptions& options);

/// Reads a project; unknown keys become warnings on standard error. The caller reports a failure.
Result<Project> loadWithWarnings(const std::string& file);

/// Problems as [{file, pointer, message}].
Json problemsJson(const std::vector<Problem>& problems);

/// A float as its shortest decimal, not as the digits of the double it converts to.
Json jsonNumber(float value);

/// WxH, whole numbers from 8 to `most`.
std::optional<glm::ivec2> parsePair(const std::string& text, int most);
/// What to say where that found none; `of` as "pixels".
Error pairExpected(const std::string& option, const std::string& found, int most, const std::string& of);

/// One object on standard output, without control characters; text that isn't UTF-8 (paths) is written with
/// replacement characters.
void printJson(const Json& object);

}  // namespace windloom::cli
