#include "engine/bake/exr_file.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>

#include "engine/core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace {

template <class Number>
Number numberAt(const std::string& bytes, std::size_t at) {
  Number value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

std::string picture(const std::filesystem::path& folder, glm::ivec2 resolution,
                    const std::vector<std::uint16_t>& rows) {
  ExrWriter writer(resolution);
  EXPECT_TRUE(writer.write(folder / "a.exr", {{"unit", "m/s"}}, rows));
  return readFile(folder / "a.exr").value();
}

std::vector<std::uint16_t> noise(glm::ivec2 resolution) {
  std::vector<std::uint16_t> rows(static_cast<std::size_t>(3 * resolution.x * resolution.y));
  std::uint32_t state = 1;
  for (std::uint16_t& value : rows) value = static_cast<std::uint16_t>((state = state * 1664525 + 1013904223) >> 16);
  return rows;
}

}  // namespace

TEST(ExrFile, HeaderBeginsWithTheMagicNumberAndEndsWithAnEmptyName) {
  const std::string bytes = exrHeader({3, 2}, {{"unit", "m/s"}});
  EXPECT_EQ(bytes.substr(0, 8), std::string("\x76\x2f\x31\x01\x02\0\0\0", 8));
  EXPECT_EQ(bytes.substr(8, 16), std::string("channels\0chlist\0", 16));
  EXPECT_EQ(bytes.substr(bytes.size() - 20), std::string("unit\0string\0\3\0\0\0m/s\0", 20));
  const std::size_t window = bytes.find("dataWindow");
  EXPECT_EQ(numberAt<std::int32_t>(bytes, window + 17), 16);
  EXPECT_EQ(numberAt<std::int32_t>(bytes, window + 29), 2) << "the last column";
  EXPECT_EQ(numberAt<std::int32_t>(bytes, window + 33), 1) << "the last row";
}

TEST(ExrFile, BlocksOf16RowsStandWhereTheTableSays) {
  const TemporaryFolder folder;
  const glm::ivec2 resolution(7, 37);
  const std::string bytes = picture(folder.path(), resolution, std::vector<std::uint16_t>(3 * 7 * 37));
  std::size_t at = exrHeader(resolution, {{"unit", "m/s"}}).size();
  std::size_t block = at + 3 * 8;
  for (const int row : {0, 16, 32}) {
    ASSERT_EQ(numberAt<std::uint64_t>(bytes, at), block);
    EXPECT_EQ(numberAt<std::int32_t>(bytes, block), row);
    block += 8 + static_cast<std::size_t>(numberAt<std::int32_t>(bytes, block + 4));
    at += 8;
  }
  EXPECT_EQ(block, bytes.size());
}

TEST(ExrFile, KeepsRowsThatCantBePackedAsTheyAre) {
  const TemporaryFolder folder;
  const glm::ivec2 resolution(64, 16);
  const std::vector<std::uint16_t> rows = noise(resolution);
  const std::string bytes = picture(folder.path(), resolution, rows);
  const std::size_t size = rows.size() * 2;
  EXPECT_EQ(numberAt<std::int32_t>(bytes, bytes.size() - size - 4), static_cast<int>(size));
  EXPECT_EQ(std::memcmp(bytes.data() + bytes.size() - size, rows.data(), size), 0);
  EXPECT_LE(bytes.size(), exrBytesAtMost(resolution));
}

TEST(ExrFile, HasTheSameBytesForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  const glm::ivec2 resolution(50, 130);
  std::vector<std::uint16_t> rows = noise(resolution);
  for (std::uint16_t& value : rows) value &= 0x0f0f;
  ::setenv("WINDLOOM_THREADS", "1", 1);
  const std::string one = picture(folder.path(), resolution, rows);
  ::setenv("WINDLOOM_THREADS", "5", 1);
  const std::string five = picture(folder.path(), resolution, rows);
  ::unsetenv("WINDLOOM_THREADS");
  EXPECT_EQ(one, five);
}

TEST(ExrFile, SaysWhereItCantWrite) {
  ExrWriter writer({1, 1});
  const Status failed = writer.write("/nowhere/a.exr", {}, std::vector<std::uint16_t>(3));
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().kind, ErrorKind::Machine);
  EXPECT_NE(failed.error().text().find("/nowhere/a.exr"), std::string::npos);
}

}  // namespace windloom
