#include "editor/core/arithmetic.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace windloom::editor {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct UnitFactor {
  std::string_view from, to;
  double factor;
};
constexpr auto kUnits = std::to_array<UnitFactor>({
    {"mm", "m", 0.001},
    {"cm", "m", 0.01},
    {"km", "m", 1000.0},
    {"ft", "m", 0.3048},
    {"in", "m", 0.0254},
    {"km/h", "m/s", 1 / 3.6},
    {"kmh", "m/s", 1 / 3.6},
    {"mph", "m/s", 0.44704},
    {"kn", "m/s", 1852.0 / 3600.0},
    {"cm/s", "m/s", 0.01},
    {"ms", "s", 0.001},
    {"min", "s", 60.0},
    {"h", "s", 3600.0},
    {"rad", "deg", 180.0 / kPi},
    {"°", "deg", 1.0},
    {"%", "", 0.01},
});

/// Recursive descent over one text. A failure is remembered once, with its place.
class Parser {
 public:
  explicit Parser(std::string_view text) : m_text(text) {}

  double expression() {
    const Depth depth(*this);
    double value = term();
    for (;;) {
      if (take('+'))
        value += term();
      else if (take('-'))
        value -= term();
      else
        return value;
    }
  }
  std::string_view rest() {
    skipSpaces();
    return m_text.substr(m_at);
  }
  [[nodiscard]] bool failed() const { return !m_failure.empty(); }
  [[nodiscard]] const std::string& failure() const { return m_failure; }

 private:
  // "((((..." must not run out of stack.
  static constexpr int kMaxDepth = 100;
  struct Depth {
    explicit Depth(Parser& owner) : parser(owner) {
      if (++parser.m_depth > kMaxDepth) parser.fail("too many parentheses");
    }
    ~Depth() { --parser.m_depth; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    Parser& parser;
  };

  double term() {
    double value = power();
    for (;;) {
      if (take('*')) {
        value *= power();
      } else if (take('/')) {
        const double divisor = power();
        if (!failed() && divisor == 0.0) fail("division by zero");
        value /= divisor;
      } else {
        return value;
      }
    }
  }
  double power() {
    const Depth depth(*this);
    if (failed()) return 0.0;
    if (take('-')) return -power();
    if (take('+')) return power();
    const double base = primary();
    return take('^') ? std::pow(base, power()) : base;
  }
  double primary() {
    if (failed()) return 0.0;
    skipSpaces();
    if (take('(')) {
      const double value = expression();
      if (!take(')')) fail("a ')' is missing");
      return value;
    }
    if (m_at < m_text.size() && isLetter(m_text[m_at])) return named();
    double value = 0.0;
    const auto [end, code] = std::from_chars(m_text.data() + m_at, m_text.data() + m_text.size(), value);
    if (code != std::errc{} || !std::isfinite(value)) {
      std::string message = "expected a number at ";
      if (m_at < m_text.size()) {
        message.append("'").append(m_text.substr(m_at, 8)).append("'");
      } else {
        message.append("the end");
      }
      fail(std::move(message));
      return 0.0;
    }
    m_at = static_cast<std::size_t>(end - m_text.data());
    return value;
  }
  double named() {
    const std::size_t begin = m_at;
    while (m_at < m_text.size() && isLetter(m_text[m_at])) ++m_at;
    const std::string_view name = m_text.substr(begin, m_at - begin);
    if (name == "pi") return kPi;
    constexpr std::string_view kFunctions[] = {"sqrt", "abs", "sin", "cos", "min", "max"};
    bool known = false;
    for (const std::string_view function : kFunctions) known = known || name == function;
    if (!known || !take('(')) {
      fail(std::string("'").append(name).append("' is not understood"));
      return 0.0;
    }
    const double a = expression();
    double b = 0.0;
    if (name == "min" || name == "max") {
      if (!take(',')) fail(std::string(name) + " needs two values");
      b = expression();
    }
    if (!take(')')) fail("a ')' is missing");
    if (name == "sqrt") return std::sqrt(a);
    if (name == "abs") return std::abs(a);
    if (name == "sin") return std::sin(a * kPi / 180.0);
    if (name == "cos") return std::cos(a * kPi / 180.0);
    return name == "min" ? std::min(a, b) : std::max(a, b);
  }

  static bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
  void skipSpaces() {
    while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\t')) ++m_at;
  }
  bool take(char c) {
    skipSpaces();
    if (failed() || m_at >= m_text.size() || m_text[m_at] != c) return false;
    ++m_at;
    return true;
  }
  void fail(std::string message) {
    if (m_failure.empty()) m_failure = std::move(message);
  }

  std::string_view m_text;
  std::size_t m_at = 0;
  int m_depth = 0;
  std::string m_failure;
};

}  // namespace

Result<double> evaluateArithmetic(std::string_view text, std::string_view unit) {
  Parser parser(text);
  double value = parser.expression();
  if (parser.failed()) return makeError(ErrorKind::BadInput, parser.failure());
  std::string_view rest = parser.rest();
  while (!rest.empty() && (rest.back() == ' ' || rest.back() == '\t')) rest.remove_suffix(1);
  if (!rest.empty() && rest != unit) {
    bool known = false;
    for (const UnitFactor& entry : kUnits) {
      if (entry.from != rest || entry.to != unit) continue;
      value *= entry.factor;
      known = true;
    }
    if (!known) {
      std::string message = std::string("'").append(rest).append("' is not understood");
      if (!unit.empty()) message.append(" (the unit is ").append(unit).append(")");
      return makeError(ErrorKind::BadInput, std::move(message));
    }
  }
  if (!std::isfinite(value)) return makeError(ErrorKind::BadInput, "the result is not a finite number");
  return value;
}

}  // namespace windloom::editor
