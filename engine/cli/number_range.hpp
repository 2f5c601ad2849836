#pragma once
// Checks options that are numbers.

#include <CLI/CLI.hpp>
#include <string>

#include "engine/core/text.hpp"

namespace windloom::cli {

/// A number from `least` to `most`. In the place of CLI::Range, which lets "nan" pass.
inline CLI::Validator numberFrom(double least, double most) {
  return CLI::Validator(
      [least, most](const std::string& text) {
        const auto number = parseNumber(text);
        if (number && *number >= least && *number <= most) return std::string();
        return "found '" + text + "', expected a number from " + shortest(least) + " to " + shortest(most);
      },
      "FLOAT in [" + shortest(least) + " - " + shortest(most) + "]");
}

}  // namespace windloom::cli
