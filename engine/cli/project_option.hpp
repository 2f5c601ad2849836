#pragma once
// What the verbs share that read a project of the user's: which of its files they may read.

#include <string>

#include "engine/core/result.hpp"
#include "engine/io/project_json.hpp"

namespace CLI {
class App;
}

namespace windloom::cli {

struct ProjectOptions {
  OutsideFiles outside = OutsideFiles::Refuse;  ///< --allow-outside
};

/// Adds --allow-outside.
void addProjectOptions(CLI::App& app, ProjectOptions& options);

/// Reads a project. Fails where one of its files can't be read, too; where it lies outside the project's folder, the
/// message says how to allow that.
Result<LoadedProject> loadWhole(const std::string& file, OutsideFiles outside);
/// The same; unknown keys become warnings on standard error.
Result<Project> loadWithWarnings(const std::string& file, OutsideFiles outside);

}  // namespace windloom::cli
