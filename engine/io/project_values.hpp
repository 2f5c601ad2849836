#pragma once
// Parameter values out of JSON. For the .cpp files of this room.

#include <optional>

#include "engine/io/json_document.hpp"
#include "engine/model/parameter.hpp"

namespace windloom {

/// A number without a fraction that fits into an int; "64.0" and "1e2" are such.
std::optional<int> wholeNumber(const JsonDocument& value);
bool isNumberArray(const JsonDocument& value, std::size_t size);
/// The value if it has the parameter's type; its range is checked by parameterProblem.
std::optional<ParameterValue> valueOfType(const ParameterInfo& info, const JsonDocument& value);

}  // namespace windloom
