#include "engine/io/json_document.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace windloom {
namespace {

Problem problemOf(const std::string& text) {
  const Result<JsonDocument> document = parseJsonDocument(text, "file");
  EXPECT_FALSE(document.ok()) << text.substr(0, 100);
  return document ? Problem{} : document.error().problems.front();
}

std::string nested(std::size_t depth) {
  return std::string(depth, '[') + std::string(depth, ']');
}

}  // namespace

TEST(JsonDocument, ReadsWhatTheLibraryReads) {
  const std::string text = R"({"b": [1, -2.5, true, null, "x", {}], "a": {"c": [[], [1]]}})";
  const Result<JsonDocument> document = parseJsonDocument(text, "file");
  ASSERT_TRUE(document.ok());
  EXPECT_EQ(*document, JsonDocument::parse(text));
  EXPECT_EQ(document->begin().key(), "b");
}

TEST(JsonDocument, RefusesAKeyTwiceWithItsPlace) {
  EXPECT_EQ(problemOf(R"({"a": 1, "b": [0, {"c": 1, "c": 2}]})").pointer, "/b/1/c");
  EXPECT_EQ(problemOf(R"({"a": {"x": 1}, "a": {"x": 1}})").pointer, "/a");
  const Result<JsonDocument> both = parseJsonDocument(R"({"a": {"x": 1, "x": 2}, "b": 0, "b": 1})", "file");
  ASSERT_FALSE(both.ok());
  EXPECT_EQ(both.error().problems.size(), 2u);
}

TEST(JsonDocument, RefusesTooDeepNesting) {
  EXPECT_TRUE(parseJsonDocument(nested(kMaxJsonDepth), "file").ok());
  EXPECT_NE(problemOf(nested(kMaxJsonDepth + 1)).message.find("nested deeper"), std::string::npos);
  EXPECT_NE(problemOf(nested(1'000'000)).message.find("nested deeper"), std::string::npos);
}

TEST(JsonDocument, RefusesTooManyKeys) {
  std::string text = "{";
  for (std::size_t i = 0; i <= kMaxJsonKeys; ++i) text += (i > 0 ? ",\"" : "\"") + std::to_string(i) + "\":0";
  EXPECT_NE(problemOf(text + "}").message.find("more than"), std::string::npos);
}

TEST(JsonDocument, SyntaxErrorsNameLineAndColumn) {
  EXPECT_EQ(problemOf("{\n  \"a\": 1,\n  \"b\": x\n}").pointer, "line 3, column 8");
  EXPECT_EQ(problemOf("[1 2]").pointer, "line 1, column 4");
  EXPECT_EQ(problemOf("[1,\n2").pointer, "line 2, column 2");
  EXPECT_NE(problemOf("[1] [2]").pointer, "");
  EXPECT_EQ(problemOf("[1] x").file, "file");
}

TEST(JsonDocument, MessagesAreTextWhateverTheBytesWere) {
  const std::string message = problemOf("\x89PNG\r\n\x1a").message;
  EXPECT_TRUE(std::ranges::all_of(message, [](char c) { return c >= 0x20 && c < 0x7f; })) << message;
}

TEST(JsonDocument, DescribesValuesShortly) {
  EXPECT_EQ(describeJson(JsonDocument(2.5)), "2.5");
  EXPECT_EQ(describeJson(JsonDocument::array({1, 2})), "[1,2]");
  EXPECT_EQ(describeJson(JsonDocument(std::vector<int>(9))), "an array of 9 values");
  EXPECT_EQ(describeJson(JsonDocument{{"a", JsonDocument::object()}}), "an object of 1 keys");
  EXPECT_LT(describeJson(JsonDocument(std::string(1000, 'x'))).size(), 80u);
}

}  // namespace windloom
