#include "engine/core/text.hpp"

#include <gtest/gtest.h>

namespace windloom {

TEST(Text, ShortestFloatReadsBackExactly) {
  EXPECT_EQ(shortest(0.1f), "0.1");
  EXPECT_EQ(shortest(1.0f / 60.0f), "0.016666668");
  for (float value : {1.1754944e-38f, 3.4028235e38f, -0.3f, 16777217.0f}) {
    EXPECT_EQ(static_cast<float>(*parseNumber(shortest(value))), value);
  }
}

TEST(Text, ParseNumberTakesWholeTextsOnly) {
  EXPECT_EQ(parseNumber(" +2.5 "), 2.5);
  EXPECT_EQ(parseNumber("-1e3"), -1000.0);
  for (const char* bad : {"", " ", "1,5", "2m", "nan", "inf", "1e999", "+-1", "0x10"}) EXPECT_FALSE(parseNumber(bad)) << bad;
}

TEST(Text, FixedNamesNonFiniteValues) {
  EXPECT_EQ(fixed(1.005, 1), "1.0");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 2), "nan");
  EXPECT_EQ(fixed(-std::numeric_limits<double>::infinity(), 2), "-inf");
}

}  // namespace windloom
