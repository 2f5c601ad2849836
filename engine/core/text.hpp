#pragma once
// Numbers and text without locales.

#include <optional>
#include <string>
#include <string_view>

namespace windloom {

/// The shortest decimal text that reads back as the same float ("0.1", "1e+20"). Must be finite.
std::string shortest(float value);
std::string shortest(double value);

/// `value` with `decimals` digits after the point.
std::string fixed(double value, int decimals);

/// A whole text as a number; nothing where it isn't one or isn't finite. Leading '+' and spaces around it are allowed.
std::optional<double> parseNumber(std::string_view text);

}  // namespace windloom
