#pragma once
// JSON text as a document, stricter than the format asks: what would lose data silently, or could be
// made to eat all memory, is refused. For the .cpp files of this room and their tests.

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

/// A key as a part of a JSON pointer: "~" and "/" escaped.
std::string pointerPart(std::string_view key);

/// A value as it appears in a message: short ones as they stand, others by kind and length.
std::string describeJson(const JsonDocument& value);

}  // namespace windloom
