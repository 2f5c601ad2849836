#pragma once
// Typed values: "2*3+1", "-(4 - 1)/2", "12 m/s".

#include <string_view>

#include "engine/core/result.hpp"

namespace windloom::editor {

/// The value of an expression of numbers, + - * / ^, parentheses, pi, sqrt abs min max sin cos (degrees). A
/// known unit after the whole expression is converted to `unit` ("cm" to "m", "km/h" to "m/s", "ms" to "s",
/// "rad" to "deg", "%" to a plain number); the unit itself is always allowed. Fails with BadInput: what is
/// wrong and where, in words for the status bar.
Result<double> evaluateArithmetic(std::string_view text, std::string_view unit = {});

}  // namespace windloom::editor
