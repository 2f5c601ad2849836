#include "editor/core/arithmetic.hpp"

#include <gtest/gtest.h>

#include <string>

namespace windloom::editor {

TEST(Arithmetic, Computes) {
  const std::pair<const char*, double> cases[] = {
      {"8", 8},         {"2*3+1", 7},     {"2+3*4", 14},      {"-(4 - 1)/2", -1.5}, {"2^3^2", 512},
      {"-2^2", -4},     {" 1.5e2 ", 150}, {"10 / 4 / 5", .5}, {"sqrt(16)", 4},      {"min(3, 2+0)", 2},
      {"max(1,-1)", 1}, {"sin(30)", 0.5}, {"cos(60)", 0.5},   {"abs(-3)*2", 6},     {"2*pi", 6.283185307179586},
      {"+3", 3},        {"2 - -3", 5}};
  for (const auto& [text, value] : cases) {
    const auto result = evaluateArithmetic(text);
    ASSERT_TRUE(result) << text;
    EXPECT_NEAR(*result, value, 1e-12) << text;
  }
}

TEST(Arithmetic, UnitsAreAllowedAndConverted) {
  EXPECT_DOUBLE_EQ(evaluateArithmetic("2*3+1 m/s", "m/s").value(), 7);
  EXPECT_DOUBLE_EQ(evaluateArithmetic("36km/h", "m/s").value(), 10);
  EXPECT_DOUBLE_EQ(evaluateArithmetic("250 cm", "m").value(), 2.5);
  EXPECT_DOUBLE_EQ(evaluateArithmetic("500 ms", "s").value(), 0.5);
  EXPECT_NEAR(evaluateArithmetic("pi rad", "deg").value(), 180, 1e-9);
  EXPECT_DOUBLE_EQ(evaluateArithmetic("40 %").value(), 0.4);
  EXPECT_FALSE(evaluateArithmetic("3 kg", "m"));
  EXPECT_FALSE(evaluateArithmetic("3 m", ""));
}

TEST(Arithmetic, RefusesWhatIsNoNumber) {
  for (const char* bad : {"", " ", "1/0", "2+", "(1", "1)", "1 2", "foo", "sqrt(-1)", "sqrt 4", "min(1)", "1e999",
                          "nan", "inf", "0x10", "1,5", "*3", "9^9^9^9"}) {
    const auto result = evaluateArithmetic(bad);
    ASSERT_FALSE(result) << bad;
    EXPECT_FALSE(result.error().text().empty());
  }
}

TEST(Arithmetic, DeepNestingIsRefusedNotACrash) {
  EXPECT_FALSE(evaluateArithmetic(std::string(100000, '(')));
  EXPECT_FALSE(evaluateArithmetic(std::string(100000, '-') + "1"));
  std::string power = "1";
  for (int i = 0; i < 100000; ++i) power += "^1";
  EXPECT_FALSE(evaluateArithmetic(power));
}

}  // namespace windloom::editor
