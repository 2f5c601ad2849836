#pragma once
// Checks of options' values. A message says what was found and what was expected; --help, manual pages and completion
// read the ranges and choices out of the checks' descriptions.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace windloom::cli {

/// A number from `least` to `most`. In the place of CLI::Range, which lets "nan" pass.
CLI::Validator numberFrom(double least, double most);

/// A whole number from `least` to `most`, in decimal digits. To be given to transform(), not to check(), since it takes
/// away the zeros before a number that CLI11 would read as octal: "010" is ten.
CLI::Validator wholeFrom(long least, long most);

/// One of `names`.
CLI::Validator oneOf(const std::vector<std::string>& names);

/// The name of a picture that is written: it ends in .png.
CLI::Validator pngName();

}  // namespace windloom::cli
