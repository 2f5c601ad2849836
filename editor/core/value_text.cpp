#include "editor/core/value_text.hpp"

#include <cctype>
#include <cmath>
#include <vector>

#include "editor/core/arithmetic.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Splits at commas outside parentheses.
std::vector<std::string_view> splitList(std::string_view text) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i == text.size() || (text[i] == ',' && depth == 0)) {
      parts.push_back(text.substr(begin, i - begin));
      begin = i + 1;
    } else if (text[i] == '(') {
      ++depth;
    } else if (text[i] == ')') {
      --depth;
    }
  }
  return parts;
}

Error expected(const ParameterInfo& info) {
  return makeError(ErrorKind::BadInput, std::string(info.label) + ": expected " + parameterExpectation(info));
}

Result<ParameterValue> choiceFromText(const ParameterInfo& info, std::string_view text) {
  const std::string typed = lower(trimmed(text));
  int found = -1, beginnings = 0;
  for (std::size_t i = 0; i < info.choices.size(); ++i) {
    if (info.choices[i] == typed) return ParameterValue(static_cast<int>(i));
    if (!typed.empty() && info.choices[i].starts_with(typed)) {
      found = static_cast<int>(i);
      ++beginnings;
    }
  }
  if (beginnings != 1) return expected(info);
  return ParameterValue(found);
}

Result<ParameterValue> switchFromText(const ParameterInfo& info, std::string_view text) {
  const std::string typed = lower(trimmed(text));
  for (const char* yes : {"true", "on", "yes", "1"}) {
    if (typed == yes) return ParameterValue(true);
  }
  for (const char* no : {"false", "off", "no", "0"}) {
    if (typed == no) return ParameterValue(false);
  }
  return expected(info);
}

Result<ParameterValue> vectorFromText(const ParameterInfo& info, std::string_view text) {
  const std::size_t count = info.type == ParameterType::Real3 ? 3 : 2;
  const std::vector<std::string_view> parts = splitList(text);
  if (parts.size() != count) return expected(info);
  double values[3] = {};
  for (std::size_t i = 0; i < count; ++i) {
    const Result<double> number = numberFromText(info, parts[i]);
    if (!number) return number.error();
    values[i] = *number;
  }
  if (info.type == ParameterType::Integer2) {
    return ParameterValue(glm::ivec2(static_cast<int>(values[0]), static_cast<int>(values[1])));
  }
  if (count == 3) return ParameterValue(glm::vec3(values[0], values[1], values[2]));
  return ParameterValue(glm::vec2(values[0], values[1]));
}

}  // namespace

Result<double> numberFromText(const ParameterInfo& info, std::string_view text) {
  // "m/s or m/s^2": each of them will do.
  Result<double> number = makeError(ErrorKind::BadInput, "no unit");
  std::string_view units = info.unit;
  for (;;) {
    const std::size_t other = units.find(" or ");
    number = evaluateArithmetic(text, units.substr(0, other));
    if (number || other == std::string_view::npos) break;
    units.remove_prefix(other + 4);
  }
  if (!number) return makeError(ErrorKind::BadInput, std::string(info.label) + ": " + number.error().text());
  const bool whole = info.type == ParameterType::Integer || info.type == ParameterType::Integer2;
  if (whole && (*number != std::round(*number) || std::abs(*number) > 2147483647.0)) return expected(info);
  return number;
}

Result<ParameterValue> valueFromText(const ParameterInfo& info, std::string_view text) {
  switch (info.type) {
    case ParameterType::Text:
      return ParameterValue(std::string(text));
    case ParameterType::Choice:
      return choiceFromText(info, text);
    case ParameterType::Switch:
      return switchFromText(info, text);
    case ParameterType::Real2:
    case ParameterType::Real3:
    case ParameterType::Integer2:
      return vectorFromText(info, text);
    case ParameterType::Real:
    case ParameterType::Integer:
    case ParameterType::Id:
      break;
  }
  const Result<double> number = numberFromText(info, text);
  if (!number) return number.error();
  if (info.type == ParameterType::Real) return ParameterValue(static_cast<float>(*number));
  return ParameterValue(static_cast<int>(*number));
}

std::string toText(const ParameterInfo& info, const ParameterValue& value) {
  struct Visitor {
    const ParameterInfo& info;
    std::string operator()(float v) const { return number(v); }
    std::string operator()(int v) const {
      const bool choice =
          info.type == ParameterType::Choice && v >= 0 && static_cast<std::size_t>(v) < info.choices.size();
      return choice ? std::string(info.choices[static_cast<std::size_t>(v)]) : std::to_string(v);
    }
    std::string operator()(bool v) const { return v ? "on" : "off"; }
    std::string operator()(const std::string& v) const { return v; }
    std::string operator()(glm::vec2 v) const { return number(v.x) + ", " + number(v.y); }
    std::string operator()(glm::vec3 v) const { return number(v.x) + ", " + number(v.y) + ", " + number(v.z); }
    std::string operator()(glm::ivec2 v) const { return std::to_string(v.x) + ", " + std::to_string(v.y); }
    static std::string number(float v) { return std::isfinite(v) ? shortest(v) : fixed(static_cast<double>(v), 0); }
  };
  return std::visit(Visitor{info}, value);
}

}  // namespace windloom::editor
