#pragma once
// JSON text as a document, stricter than the format asks: what would lose data silently, or could be
// made to eat all memory, is refused. For .cpp files that read JSON, and their tests.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "engine/core/result.hpp"

namespace windloom {

/// Keys keep their order, so that unknown ones are written back where they stood.
using JsonDocument = nlohmann::ordered_json;

inline constexpr std::size_t kMaxJsonDepth = 64;
inline constexpr std::size_t kMaxJsonKeys = 256;          ///< in one object
inline constexpr std::size_t kMaxJsonValues = 8'000'000;  ///< in one document

/// Fails with BadInput: text that isn't JSON (place "line 3, column 7"), a key twice in one object (JSON
/// pointer), or more than the limits above. `file` goes into the problems.
Result<JsonDocument> parseJsonDocument(std::string_view text, const std::string& file);

/// For text that another parser reads: that it nests no deeper than kMaxJsonDepth and holds no more than `mostValues`,
/// found by looking at its brackets and commas once, without taking memory. Whether it is JSON is not looked at. Fails
/// with BadInput.
Status checkJsonExtent(std::string_view text, std::size_t mostValues, const std::string& file);

/// A key as a part of a JSON pointer: "~" and "/" escaped.
std::string pointerPart(std::string_view key);

/// A value as it appears in a message: short ones as they stand, others by kind and length.
std::string describeJson(const JsonDocument& value);

}  // namespace windloom
