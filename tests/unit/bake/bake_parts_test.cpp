#include "engine/bake/bake_parts.hpp"

#include <gtest/gtest.h>

#include "engine/bake/fill_template.hpp"
#include "engine/bake/seam.hpp"
#include "engine/core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace {

BakePart partOf(int first, int last) {
  BakePart part{first, last, 0.1f * static_cast<float>(last), {}, {{}}};
  for (int n = first; n <= last; ++n) {
    part.groups[0].push_back({{"path", std::to_string(n)}, {"role", "field"}, {"encoding", "float16"}, {"frame", n}});
  }
  return part;
}

std::vector<int> framesOf(const BakePart& part) {
  std::vector<int> frames;
  for (const auto& entry : part.groups[0]) frames.push_back(entry["frame"]);
  return frames;
}

}  // namespace

TEST(BakeParts, AreAWholeWhenEveryFrameIsThere) {
  EXPECT_FALSE(joinParts({}, 4));
  EXPECT_FALSE(joinParts({partOf(0, 2)}, 4));
  EXPECT_FALSE(joinParts({partOf(1, 3)}, 4));
  EXPECT_FALSE(joinParts({partOf(0, 0), partOf(2, 3)}, 4));
  const std::optional<BakePart> whole = joinParts({partOf(0, 1), partOf(2, 3)}, 4);
  ASSERT_TRUE(whole);
  EXPECT_EQ(framesOf(*whole), (std::vector{0, 1, 2, 3}));
  EXPECT_EQ(whole->fastest, 0.3f);
}

TEST(BakeParts, TellWhichFramesAreMissing) {
  using Ranges = std::vector<std::pair<int, int>>;
  EXPECT_EQ(missingFrames({}, 4), (Ranges{{0, 3}}));
  EXPECT_EQ(missingFrames({partOf(0, 3)}, 4), Ranges{});
  EXPECT_EQ(missingFrames({partOf(1, 2), partOf(2, 2), partOf(5, 6)}, 9), (Ranges{{0, 0}, {3, 4}, {7, 8}}));
}

TEST(BakeParts, TakeEveryFrameOnceWhereTheyOverlap) {
  const std::optional<BakePart> whole = joinParts({partOf(0, 2), partOf(1, 1), partOf(1, 4), partOf(4, 5)}, 6);
  ASSERT_TRUE(whole);
  EXPECT_EQ(framesOf(*whole), (std::vector{0, 1, 2, 3, 4, 5}));
}

TEST(BakeParts, AreReadBackAsTheyWereNoted) {
  const TemporaryFolder folder;
  BakePart part = partOf(3, 4);
  part.fastest = 0.1f;
  part.seam = {1.25f, 0.7f};
  ASSERT_TRUE(writePart(folder.path(), part));
  ASSERT_TRUE(writePart(folder.path(), partOf(0, 2)));
  ASSERT_TRUE(writePart(folder.path(), partOf(7, 7)));
  for (const char* name : {"0", "1", "2", "3", "4"}) ASSERT_TRUE(writeFileAtomically(folder.path() / name, "a frame"));
  ASSERT_TRUE(writeFileAtomically(folder.path() / "part-9-9.json", "{\"first\": 9}"));
  ASSERT_TRUE(writeFileAtomically(folder.path() / "part-8-8.json", "{"));
  const std::vector<BakePart> parts = readParts(folder.path());
  ASSERT_EQ(parts.size(), 2u) << "a damaged note is a missing part, and so is one without its files";
  EXPECT_EQ(parts[0].first, 0);
  EXPECT_EQ(parts[1].fastest, 0.1f);
  EXPECT_EQ(parts[1].seam.seam, 1.25f);
  EXPECT_EQ(parts[1].seam.step, 0.7f);
  EXPECT_EQ(parts[1].groups, part.groups);
}

TEST(BakeParts, AreMissingWhereTheirNoteNamesFilesElsewhereOrNonsense) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileAtomically(folder.path() / "0", "a frame"));
  const std::string entry = R"({"path": "0", "role": "field", "encoding": "float16", "frame": 0})";
  const auto partsWith = [&](const std::string& numbers, const std::string& group) {
    const std::string note = "{" + numbers + R"(, "fastest": 1, "seam": 0, "step": 0, "groups": )" + group + "}";
    EXPECT_TRUE(writeFileAtomically(folder.path() / "part-0-0.json", note));
    return readParts(folder.path()).size();
  };
  const std::string numbers = R"("first": 0, "last": 0)";
  EXPECT_EQ(partsWith(numbers, "[[" + entry + "]]"), 1u);
  for (const char* bad :
       {R"("first": -1, "last": 0)", R"("first": 0, "last": 1e300)", R"("first": 0, "last": 2147483647)",
        R"("first": 0.5, "last": 1)", R"("first": 1, "last": 0)", R"("first": "0", "last": 0)"}) {
    EXPECT_EQ(partsWith(bad, "[[" + entry + "]]"), 0u) << bad;
  }
  for (const char* bad : {R"([[{"path": "../0", "role": "field", "encoding": "float16"}]])",
                          R"([[{"path": "/etc/hostname", "role": "a", "encoding": "b"}]])", R"([[{"path": "0"}]])",
                          R"([["0"]])", R"([{"path": "0"}])", R"("groups")",
                          R"([[{"path": "0", "role": "field", "encoding": "float16", "frame": "first"}]])",
                          R"([[{"path": "0", "role": "field", "encoding": "float16", "tiles": "abc"}]])",
                          R"([[{"path": "0", "role": "field", "encoding": "float16", "tiles": [0, 1]}]])",
                          R"([[{"path": "0", "role": "field", "encoding": "float16", "strength": "1"}]])",
                          R"([[{"path": "0", "role": "field", "encoding": "float16", "import": {"a\n[b]": 1}}]])",
                          R"([[{"path": "0", "role": "field", "encoding": "float16", "import": {"a": [1]}}]])",
                          R"([[{"path": "\")+f()+(\"", "role": "field", "encoding": "float16"}]])"}) {
    EXPECT_EQ(partsWith(numbers, bad), 0u) << bad;
  }
  EXPECT_EQ(partsWith(numbers, std::string(100'000, '[')), 0u) << "nested too deep";
}

TEST(BakeParts, BehindLinksAreMissing) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const fs::path parts = folder.path() / ".parts-0123456789abcdef";
  fs::create_directory(parts);
  ASSERT_TRUE(writePart(parts, partOf(0, 0)));
  ASSERT_TRUE(writeFileAtomically(parts / "0", "a frame"));
  EXPECT_EQ(readParts(parts).size(), 1u);
  fs::create_directory_symlink(parts, folder.path() / "link");
  EXPECT_TRUE(readParts(folder.path() / "link").empty());
  fs::rename(parts / "0", folder.path() / "elsewhere");
  fs::create_symlink("../elsewhere", parts / "0");
  EXPECT_TRUE(readParts(parts).empty());
}

TEST(Seam, IsTheStepFromTheLastFrameToTheFirst) {
  SeamMeter meter;
  const std::vector<glm::vec2> a = {{0, 0}, {1, 0}}, b = {{0, 0.5f}, {1, 0}}, c = {{3, 4}, {1, 0}};
  meter.compare(0, b, a);
  meter.compare(1, a, c);
  meter.compare(2, c, c);
  EXPECT_EQ(meter.report().seam, 0.5f);
  EXPECT_EQ(meter.report().step, 5.0f);
}

TEST(Template, ReplacesKeysAndLeavesOtherAts) {
  EXPECT_EQ(fillTemplate("a @ONE@ b@TWO@@ONE@ @export mail@home @", {{"ONE", "1"}, {"TWO", ""}}),
            "a 1 b1 @export mail@home @\n");
}

TEST(Template, KeepsLinesWhoseKeyIsSet) {
  const std::string text = "@if A\na\n@if B\nab\n@end\na2\n@end\n@if C\nc\n@end\nend";
  EXPECT_EQ(fillTemplate(text, {{"A", "1"}, {"B", "1"}, {"C", "0"}}), "a\nab\na2\nend\n");
  EXPECT_EQ(fillTemplate(text, {{"A", "1"}, {"B", ""}}), "a\na2\nend\n");
  EXPECT_EQ(fillTemplate(text, {{"B", "1"}, {"C", "1"}}), "c\nend\n");
}

}  // namespace windloom
