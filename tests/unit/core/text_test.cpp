#include "engine/core/text.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "engine/core/log.hpp"
#include "engine/core/result.hpp"

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
  for (const char* bad : {"", " ", "1,5", "2m", "nan", "inf", "1e999", "+-1", "0x10"})
    EXPECT_FALSE(parseNumber(bad)) << bad;
}

TEST(Text, FixedNamesNonFiniteValues) {
  EXPECT_EQ(fixed(1.005, 1), "1.0");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 2), "nan");
  EXPECT_EQ(fixed(-std::numeric_limits<double>::infinity(), 2), "-inf");
}

TEST(Text, PrintableLetsNoControlCharacterThrough) {
  EXPECT_EQ(printable("Wiese \xC3\xBC, \xE2\x82\xAC, \xF0\x9F\x8C\xBE; C:\\x"),
            "Wiese \xC3\xBC, \xE2\x82\xAC, \xF0\x9F\x8C\xBE; C:\\x");
  EXPECT_EQ(printable(std::string_view("\0\t\r\n\x1B[2J\x7F", 9)), "\\x00\\x09\\x0D\\x0A\\x1B[2J\\x7F");
  EXPECT_EQ(printable("a\xC2\x80\xC2\x9F\xC2\xA0"), "a\\xC2\\x80\\xC2\\x9F\xC2\xA0") << "C1, and the first after it";
  EXPECT_EQ(printable("\x9B"
                      "31m"),
            "\\x9B31m")
      << "C1 as one byte";
  EXPECT_EQ(printable("\xC0\x9B|\xED\xA0\x80|\xF5|\xC3"), "\\xC0\\x9B|\\xED\\xA0\\x80|\\xF5|\\xC3") << "no UTF-8";
  EXPECT_EQ(printable(""), "");
}

TEST(Text, PrintableLinesStayOneMessage) {
  EXPECT_EQ(printableLines("one\ntwo\n\n    three\n"), "one\n    two\n    three");
  EXPECT_EQ(printableLines("one\n\x1B[31mtwo\r\n"), "one\n    \\x1B[31mtwo\\x0D");
  const std::string once = printableLines("a\nb\n\nc\n    \x7F");
  EXPECT_EQ(printableLines(once), once);
  EXPECT_EQ(printableLines("\n"), "");
}

TEST(Text, ProblemsAndTheLogForgeNoLines) {
  const std::string hostile = "\x1B]0;pwned\x07\nwindloom: fake";
  const Error error = makeError(ErrorKind::BadInput, "a\n.json", "/" + hostile, "found \xC2\x9B");
  EXPECT_EQ(error.text(), "a\\x0A.json: /\\x1B]0;pwned\\x07\\x0Awindloom: fake: found \\xC2\\x9B");
  std::string told;
  setLogSink([&](LogLevel, std::string_view text) { told = text; });
  ::testing::internal::CaptureStderr();
  logWarning("can't read " + hostile);
  setLogSink({});
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "warning: can't read \\x1B]0;pwned\\x07\n    windloom: fake\n");
  EXPECT_EQ(told, "can't read \\x1B]0;pwned\\x07\n    windloom: fake");
}

}  // namespace windloom
