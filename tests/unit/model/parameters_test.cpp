#include "engine/model/parameters.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace windloom {
namespace {

template <class Owner>
class ParameterTables : public testing::Test {};
using Owners =
    testing::Types<FieldSettings, SolverSettings, AmbientWind, Point, Arrow, Signal, Obstacle, Species, Collider,
                   Surface, Rotor, Probe, Camera, TerrainSettings, GrassSettings, BezierSettings, ShellSettings>;
TYPED_TEST_SUITE(ParameterTables, Owners);

}  // namespace

TYPED_TEST(ParameterTables, KeysAreUniqueAndNestedOnesStandTogether) {
  std::set<std::string_view> keys, groups;
  std::string_view lastGroup;
  for (const Parameter<TypeParam>& parameter : parametersOf<TypeParam>()) {
    const std::string_view key = parameter.info.key;
    EXPECT_TRUE(keys.insert(key).second) << key;
    EXPECT_FALSE(parameter.info.label.empty()) << key;
    EXPECT_TRUE(parameter.info.help.ends_with('.')) << key;
    const std::size_t slash = key.find('/');
    const std::string_view group = slash == key.npos ? std::string_view() : key.substr(0, slash);
    const bool begins = !group.empty() && group != lastGroup;
    EXPECT_TRUE(!begins || groups.insert(group).second) << key;
    lastGroup = group;
  }
}

TYPED_TEST(ParameterTables, DefaultsAreLegal) {
  for (const Parameter<TypeParam>& parameter : parametersOf<TypeParam>()) {
    if (parameter.info.type == ParameterType::Id) continue;
    EXPECT_EQ(parameterProblem(parameter.info, parameter.get(TypeParam{})), "") << parameter.info.key;
  }
}

TYPED_TEST(ParameterTables, SetTakesWhatGetGives) {
  TypeParam owner;
  for (const Parameter<TypeParam>& parameter : parametersOf<TypeParam>()) {
    const ParameterValue value = parameter.get(owner);
    parameter.set(owner, value);
    EXPECT_EQ(parameter.get(owner), value) << parameter.info.key;
  }
}

TYPED_TEST(ParameterTables, NumbersHaveARangeAndAStep) {
  for (const Parameter<TypeParam>& parameter : parametersOf<TypeParam>()) {
    const ParameterType type = parameter.info.type;
    if (type == ParameterType::Switch || type == ParameterType::Text) continue;
    if (type == ParameterType::Choice) {
      EXPECT_FALSE(parameter.info.choices.empty()) << parameter.info.key;
      continue;
    }
    EXPECT_LT(parameter.info.min, parameter.info.max) << parameter.info.key;
    EXPECT_GT(parameter.info.step, 0) << parameter.info.key;
  }
}

TEST(ParameterProblem, NamesWhatWasFoundAndExpected) {
  const ParameterInfo info{
      .key = "strength", .label = "", .unit = "m/s", .help = "", .type = ParameterType::Real, .min = 0, .max = 100};
  EXPECT_EQ(parameterProblem(info, -3.0f), "found -3, expected a number from 0 to 100 (m/s)");
  EXPECT_EQ(parameterProblem(info, std::numeric_limits<float>::quiet_NaN()),
            "found nan, expected a number from 0 to 100 (m/s)");
  EXPECT_EQ(parameterProblem(info, 100.0f), "");
}

TEST(ParameterProblem, ComparesBoundsAsFloats) {
  const ParameterInfo info{
      .key = "timeStep", .label = "", .unit = "s", .help = "", .type = ParameterType::Real, .min = 1e-4, .max = 0.3};
  EXPECT_EQ(parameterProblem(info, 1e-4f), "");
  EXPECT_EQ(parameterProblem(info, 0.3f), "");
}

TEST(ParameterProblem, TextIsUtf8WithoutControlCharacters) {
  const ParameterInfo& info = kProjectName;
  const auto legal = [&](const char* text) { return parameterProblem(info, std::string(text)).empty(); };
  EXPECT_TRUE(legal(""));
  EXPECT_TRUE(
      legal("Br\xc3\xbc"
            "cke \xe2\x82\xac \xf0\x9f\x8c\xbe"));
  for (const char* bad : {"a\tb", "\x7f", "\xff", "\xc3", "\xc0\xaf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xe2\x82"}) {
    EXPECT_FALSE(legal(bad)) << bad;
  }
  EXPECT_TRUE(parameterProblem(info, std::string(kMaxTextBytes, 'x')).empty());
  EXPECT_FALSE(parameterProblem(info, std::string(kMaxTextBytes + 1, 'x')).empty());
}

}  // namespace windloom
