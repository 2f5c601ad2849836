#include <gtest/gtest.h>

#include <random>

#include "engine/model/validate.hpp"
#include "tests/unit/io/project_fixture.hpp"

namespace windloom {
namespace {

using Random = std::mt19937;

std::size_t upTo(Random& random, std::size_t count) {
  return random() % count;
}

/// Pieces that are most likely to meet a case nobody thought of.
std::string piece(Random& random, const std::string& text) {
  static const char* const kPieces[] = {"{",
                                        "}",
                                        "[",
                                        "]",
                                        ",",
                                        ":",
                                        "\"",
                                        "null",
                                        "true",
                                        "-1",
                                        "0",
                                        "1e39",
                                        "1e400",
                                        "-0",
                                        "4294967296",
                                        "18446744073709551616",
                                        "\\u0000",
                                        "\\ud800",
                                        "\xff",
                                        "\"id\": 1",
                                        "\"position\": []",
                                        "\"keys\": [[0]]",
                                        "\"keys\": [[0, 0, 0, 0]]",
                                        "\"shape\": \"mesh\"",
                                        "0.1",
                                        "\"kind\": \"pulse\"",
                                        "\"/\": 1",
                                        "\n"};
  if (random() % 3 != 0) return kPieces[upTo(random, std::size(kPieces))];
  const std::size_t begin = upTo(random, text.size());
  return text.substr(begin, 1 + upTo(random, 60));
}

std::string mutated(Random& random, std::string text) {
  for (std::size_t i = 0, count = 1 + upTo(random, 4); i < count && !text.empty(); ++i) {
    const std::size_t at = upTo(random, text.size());
    switch (random() % 5) {
      case 0:
        text[at] = static_cast<char>(random() % 256);
        break;
      case 1:
        text.erase(at, 1 + upTo(random, 20));
        break;
      case 2:
        text.insert(at, piece(random, text));
        break;
      case 3:
        text.replace(at, 1 + upTo(random, 8), piece(random, text));
        break;
      default:
        if (random() % 8 == 0) text.resize(at);
        break;
    }
  }
  return text;
}

}  // namespace

TEST(ProjectJson, TenThousandMutatedFilesAreReadOrRefusedWithAMessage) {
  Random random(20240917);
  int accepted = 0;
  for (int i = 0; i < 10'000; ++i) {
    const std::string text = mutated(random, kRichProject);
    const Result<LoadedProject> loaded = parseProject(text, "fuzz");
    if (!loaded) {
      ASSERT_FALSE(loaded.error().problems.empty());
      for (const Problem& problem : loaded.error().problems) ASSERT_FALSE(problem.message.empty());
      continue;
    }
    ++accepted;
    ASSERT_TRUE(validate(loaded->project).empty());
    const std::string written = writeProject(loaded->project);
    const Result<LoadedProject> again = parseProject(written, "again");
    ASSERT_TRUE(again.ok()) << again.error().text() << "\n" << text;
    ASSERT_EQ(writeProject(again->project), written) << text;
  }
  EXPECT_GT(accepted, 500);
}

}  // namespace windloom
