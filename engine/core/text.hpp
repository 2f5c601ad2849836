#pragma once
// Numbers and text without locales.

#include <cstddef>
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

/// Bytes of the UTF-8 sequence at the start of `text`, which isn't empty; 0 where it is none (overlong forms,
/// surrogates and values above U+10FFFF included).
std::size_t utf8Length(std::string_view text);

/// One line for people to read, on a terminal too: control characters (C0, DEL, C1) and bytes that are no UTF-8 are
/// written as \xNN, so that text from a file can't move the cursor, begin another line or change colours.
std::string printable(std::string_view text);

/// The same for text of several lines: each line after the first is indented, so that none can be taken for another
/// message; empty ones are left out. What this gave stays as it is.
std::string printableLines(std::string_view text);

}  // namespace windloom
