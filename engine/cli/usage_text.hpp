#pragma once
// What people read who mistyped: --help, and why a command line wasn't understood.

#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class FormatterBase;
class ParseError;
}  // namespace CLI

namespace windloom::cli {

/// CLI11's --help without its "..." behind options of which each takes one word.
std::shared_ptr<CLI::FormatterBase> helpFormatter();

/// Why CLI11 refused `words` (without the program's name), and what may have been meant. `app` has just parsed them;
/// with or without verbs.
std::string usageProblem(CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words);

}  // namespace windloom::cli
