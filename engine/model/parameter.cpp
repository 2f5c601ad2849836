#include "engine/model/parameter.hpp"

#include <charconv>
#include <cmath>

#include "engine/core/text.hpp"

namespace windloom {
namespace {

std::string numberText(float value) {
  return std::isfinite(value) ? shortest(value) : (std::isnan(value) ? "nan" : (value > 0 ? "inf" : "-inf"));
}

std::string listText(std::initializer_list<std::string> parts) {
  std::string list;
  for (const std::string& part : parts) list.append(list.empty() ? "[" : ", ").append(part);
  return list.append("]");
}

std::string foundText(const ParameterInfo& info, const ParameterValue& value) {
  struct Visitor {
    const ParameterInfo& info;
    std::string operator()(float v) const { return numberText(v); }
    std::string operator()(int v) const {
      if (info.type == ParameterType::Id) return std::to_string(static_cast<unsigned>(v));
      return (info.type == ParameterType::Choice ? "choice " : "") + std::to_string(v);
    }
    std::string operator()(bool v) const { return v ? "true" : "false"; }
    std::string operator()(glm::vec2 v) const { return listText({numberText(v.x), numberText(v.y)}); }
    std::string operator()(glm::vec3 v) const { return listText({numberText(v.x), numberText(v.y), numberText(v.z)}); }
    std::string operator()(glm::ivec2 v) const { return listText({std::to_string(v.x), std::to_string(v.y)}); }
    std::string operator()(const std::string& v) const { return std::to_string(v.size()) + " bytes"; }
  };
  return std::visit(Visitor{info}, value);
}

/// The bounds are compared as floats: 1e-4f is a little below 1e-4, and still meant.
bool inRange(const ParameterInfo& info, float value) {
  return std::isfinite(value) && value >= static_cast<float>(info.min) && value <= static_cast<float>(info.max);
}

bool inRange(const ParameterInfo& info, int value) {
  return value >= info.min && value <= info.max;
}

bool legalText(std::string_view text) {
  if (text.size() > kMaxTextBytes) return false;
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    if (length == 0 || static_cast<unsigned char>(text.front()) < 0x20 || text.front() == 0x7F) return false;
    text.remove_prefix(length);
  }
  return true;
}

struct Legal {
  const ParameterInfo& info;
  bool operator()(float v) const { return inRange(info, v); }
  bool operator()(int v) const { return inRange(info, v); }
  bool operator()(bool) const { return true; }
  bool operator()(glm::vec2 v) const { return inRange(info, v.x) && inRange(info, v.y); }
  bool operator()(glm::vec3 v) const { return inRange(info, v.x) && inRange(info, v.y) && inRange(info, v.z); }
  bool operator()(glm::ivec2 v) const { return inRange(info, v.x) && inRange(info, v.y); }
  bool operator()(const std::string& v) const { return legalText(v); }
};

/// Never with an exponent: "1000000", "0.0001".
std::string plainNumber(double value) {
  char buffer[400];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed).ptr};
}

}  // namespace

std::string parameterProblem(const ParameterInfo& info, const ParameterValue& value) {
  if (std::visit(Legal{info}, value)) return {};
  return "found " + foundText(info, value) + ", expected " + parameterExpectation(info);
}

std::string parameterRange(const ParameterInfo& info) {
  return plainNumber(info.min) + " to " + plainNumber(info.max);
}

std::string parameterExpectation(const ParameterInfo& info) {
  std::string range = " from " + parameterRange(info);
  if (!info.unit.empty()) range += " (" + std::string(info.unit) + ")";
  switch (info.type) {
    case ParameterType::Real:
      return "a number" + range;
    case ParameterType::Integer:
      return "a whole number" + range;
    case ParameterType::Real2:
      return "two numbers" + range;
    case ParameterType::Real3:
      return "three numbers" + range;
    case ParameterType::Integer2:
      return "two whole numbers" + range;
    case ParameterType::Id:
      return "an id" + range;
    case ParameterType::Switch:
      return "true or false";
    case ParameterType::Text:
      return "text of at most " + std::to_string(kMaxTextBytes) + " bytes of UTF-8 without control characters";
    case ParameterType::Choice:
      break;
  }
  std::string list;
  for (const std::string_view name : info.choices) list.append(list.empty() ? "" : ", ").append(name);
  return info.choices.size() == 1 ? list : "one of " + list;
}

}  // namespace windloom
