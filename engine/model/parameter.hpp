#pragma once
// One description per parameter (key, label, unit, range, step, help) feeds the inspector, the JSON
// check, the JSON Schema, the command line and docs/parameters.md. The default is the value of a
// default-constructed owner.

#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace windloom {

// GCC 12 takes the scoped enumerator Id for a shadow of windloom::Id.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
enum class ParameterType { Real, Integer, Switch, Choice, Real2, Real3, Integer2, Text, Id };
#pragma GCC diagnostic pop

/// Longest name, in bytes.
inline constexpr std::size_t kMaxTextBytes = 256;

/// A parameter's value, independent of who owns it. Choice and Id travel as int.
using ParameterValue = std::variant<float, int, bool, glm::vec2, glm::vec3, glm::ivec2, std::string>;

struct ParameterInfo {
  std::string_view key;    ///< place in the owner's JSON object; nested keys by '/': "gusts/strength"
  std::string_view label;  ///< for people
  std::string_view unit;   ///< "m", "m/s", "s", "deg", "1/s", ... or empty
  std::string_view help;   ///< one sentence
  ParameterType type = ParameterType::Real;
  double min = 0;   ///< least legal value, each component; numbers only
  double max = 0;   ///< largest legal value
  double step = 0;  ///< one notch of a slider or arrow key
  std::span<const std::string_view> choices = {};  ///< names in JSON, index = enum value; Choice only
};

template <class Owner>
struct Parameter {
  ParameterInfo info;
  ParameterValue (*get)(const Owner&);
  void (*set)(Owner&, const ParameterValue&);  ///< the value must hold the alternative that `get` returns
};

/// The parameters of a struct in the order of the file. Specialised for every described struct in
/// parameters.hpp.
template <class Owner>
std::span<const Parameter<Owner>> parametersOf();

/// Where `value` is outside the described range, not finite, or no legal choice: what was found and
/// expected, e.g. "found -3, expected a number from 0 to 100 (m/s)". Empty where it is legal.
std::string parameterProblem(const ParameterInfo& info, const ParameterValue& value);

/// "a number from 0 to 100 (m/s)", "one of speed, force", "true or false" ...
std::string parameterExpectation(const ParameterInfo& info);

/// The range of a number as people write it: "0.0001 to 1000000".
std::string parameterRange(const ParameterInfo& info);

// Makers, used by parameters.cpp: real<&Arrow::strength>("strength", ...).
namespace detail {
template <class T>
struct MemberTraits;
template <class O, class V>
struct MemberTraits<V O::*> {
  using Owner = O;
  using Value = V;
};
template <auto Member>
using OwnerOf = typename MemberTraits<decltype(Member)>::Owner;
template <auto Member>
using ValueOf = typename MemberTraits<decltype(Member)>::Value;

/// `Stored` is the variant's alternative; the member converts to and from it.
template <auto Member, class Stored>
constexpr Parameter<OwnerOf<Member>> describe(ParameterInfo info) {
  return {info, [](const OwnerOf<Member>& owner) -> ParameterValue { return static_cast<Stored>(owner.*Member); },
          [](OwnerOf<Member>& owner, const ParameterValue& value) {
            owner.*Member = static_cast<ValueOf<Member>>(std::get<Stored>(value));
          }};
}
}  // namespace detail

template <auto Member>
constexpr auto real(std::string_view key, std::string_view label, std::string_view unit, double min, double max,
                    double step, std::string_view help) {
  using V = detail::ValueOf<Member>;
  constexpr ParameterType type = std::is_same_v<V, glm::vec2>   ? ParameterType::Real2
                                 : std::is_same_v<V, glm::vec3> ? ParameterType::Real3
                                                                : ParameterType::Real;
  return detail::describe<Member, V>({key, label, unit, help, type, min, max, step});
}

template <auto Member>
constexpr auto integer(std::string_view key, std::string_view label, std::string_view unit, int min, int max, int step,
                       std::string_view help) {
  constexpr bool pair = std::is_same_v<detail::ValueOf<Member>, glm::ivec2>;
  using Stored = std::conditional_t<pair, glm::ivec2, int>;
  constexpr ParameterType type = pair ? ParameterType::Integer2 : ParameterType::Integer;
  return detail::describe<Member, Stored>({key, label, unit, help, type, double(min), double(max), double(step)});
}

template <auto Member>
constexpr auto toggle(std::string_view key, std::string_view label, std::string_view help) {
  return detail::describe<Member, bool>({key, label, "", help, ParameterType::Switch});
}

template <auto Member>
constexpr auto choice(std::string_view key, std::string_view label, std::span<const std::string_view> names,
                      std::string_view help) {
  const double last = double(names.size()) - 1;
  return detail::describe<Member, int>({key, label, "", help, ParameterType::Choice, 0, last, 1, names});
}

template <auto Member>
constexpr auto text(std::string_view key, std::string_view label, std::string_view help) {
  return detail::describe<Member, std::string>({key, label, "", help, ParameterType::Text});
}

template <auto Member>
constexpr auto identifier(std::string_view key, std::string_view label, std::string_view help) {
  return detail::describe<Member, int>({key, label, "", help, ParameterType::Id, 1, 2147483647.0, 1});
}

}  // namespace windloom
