#include "engine/io/project_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace windloom {

std::optional<int> wholeNumber(const JsonDocument& value) {
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  constexpr double kLimit = std::numeric_limits<int>::max();
  if (!(std::abs(number) <= kLimit) || number != std::floor(number)) return std::nullopt;
  return static_cast<int>(number);
}

bool isNumberArray(const JsonDocument& value, std::size_t size) {
  return value.is_array() && value.size() == size &&
         std::ranges::all_of(value, [](const JsonDocument& v) { return v.is_number(); });
}

std::optional<ParameterValue> valueOfType(const ParameterInfo& info, const JsonDocument& value) {
  switch (info.type) {
    case ParameterType::Real:
      if (value.is_number()) return value.get<float>();
      break;
    case ParameterType::Integer:
    case ParameterType::Id:
      if (const auto number = wholeNumber(value)) return *number;
      break;
    case ParameterType::Switch:
      if (value.is_boolean()) return value.get<bool>();
      break;
    case ParameterType::Choice:
      if (value.is_string()) {
        const auto found = std::ranges::find(info.choices, value.get_ref<const std::string&>());
        if (found != info.choices.end()) return static_cast<int>(found - info.choices.begin());
      }
      break;
    case ParameterType::Real2:
      if (isNumberArray(value, 2)) return glm::vec2(value[0].get<float>(), value[1].get<float>());
      break;
    case ParameterType::Real3:
      if (isNumberArray(value, 3))
        return glm::vec3(value[0].get<float>(), value[1].get<float>(), value[2].get<float>());
      break;
    case ParameterType::Integer2:
      if (isNumberArray(value, 2)) {
        const auto x = wholeNumber(value[0]), y = wholeNumber(value[1]);
        if (x && y) return glm::ivec2(*x, *y);
      }
      break;
    case ParameterType::Text:
      if (value.is_string()) return value.get<std::string>();
      break;
  }
  return std::nullopt;
}

}  // namespace windloom
