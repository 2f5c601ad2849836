#pragma once
// Descriptions of the project file made from the parameter tables, so that they can't disagree with
// what the reader checks. `windloom docs` writes them into docs/; a test says when they are out of date.

#include <string>

namespace windloom {

/// JSON Schema (draft 2020-12) of a project file of the current version: docs/project.schema.json.
/// Unknown keys are legal. What it can't say (ids that must exist, unique ids) is validate()'s.
std::string projectSchemaJson();

/// All parameters with unit, range, default and help, as Markdown: docs/parameters.md.
std::string parametersMarkdown();

}  // namespace windloom
