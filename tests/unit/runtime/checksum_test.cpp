#include "engine/runtime/checksum.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace windloom::runtime {
namespace {

/// The definition, bit by bit.
std::uint32_t byDefinition(const unsigned char* bytes, std::size_t size) {
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = 0; i < size; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1u) != 0 ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
  }
  return ~crc;
}

std::vector<unsigned char> randomBytes(std::size_t size) {
  std::mt19937 random(7);
  std::vector<unsigned char> bytes(size);
  for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(random());
  return bytes;
}

}  // namespace

TEST(Checksum, IsTheOneOfZlib) {
  EXPECT_EQ(windloom_checksum(0, "123456789", 9), 0xCBF43926u);
  const std::string text = "The quick brown fox jumps over the lazy dog";
  EXPECT_EQ(windloom_checksum(0, text.data(), text.size()), 0x414FA339u);
  EXPECT_EQ(windloom_checksum(windloom_checksum(0, text.data(), 17), text.data() + 17, text.size() - 17), 0x414FA339u);
}

TEST(Checksum, IsTheSameByEveryWayAndForEveryLength) {
  const std::vector<unsigned char> bytes = randomBytes(3000);
  for (std::size_t size = 0; size < bytes.size(); size += size < 400 ? 1 : 61) {
    for (const std::size_t from : {std::size_t{0}, std::size_t{3}}) {
      if (from > size) continue;
      const std::uint32_t expected = byDefinition(bytes.data() + from, size - from);
      ASSERT_EQ(windloom_checksum(0, bytes.data() + from, size - from), expected) << from << " " << size;
      ASSERT_EQ(windloom_checksum_plain(0, bytes.data() + from, size - from), expected) << from << " " << size;
    }
  }
}

TEST(Checksum, GoesOnWhereItStopped) {
  const std::vector<unsigned char> bytes = randomBytes(3000);
  const std::uint32_t whole = byDefinition(bytes.data(), bytes.size());
  for (std::size_t cut = 0; cut <= bytes.size(); cut += 37) {
    const std::uint32_t first = windloom_checksum(0, bytes.data(), cut);
    EXPECT_EQ(windloom_checksum(first, bytes.data() + cut, bytes.size() - cut), whole);
    EXPECT_EQ(windloom_checksum_plain(first, bytes.data() + cut, bytes.size() - cut), whole);
  }
}

}  // namespace windloom::runtime
