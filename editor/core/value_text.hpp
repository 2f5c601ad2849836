#pragma once
// Parameter values as people type and read them.

#include <string>
#include <string_view>

#include "engine/core/result.hpp"
#include "engine/model/parameter.hpp"

namespace windloom::editor {

/// Arithmetic with the parameter's unit; whole where the parameter is.
Result<double> numberFromText(const ParameterInfo& info, std::string_view text);
/// Numbers as above (vectors: one for each component, with commas), a choice's name or the beginning of only one
/// of them, "true", "on", "yes" or their opposites for switches.
Result<ParameterValue> valueFromText(const ParameterInfo& info, std::string_view text);
/// "8", "40, 0", "speed", "on": a value without its unit.
std::string toText(const ParameterInfo& info, const ParameterValue& value);

}  // namespace windloom::editor
