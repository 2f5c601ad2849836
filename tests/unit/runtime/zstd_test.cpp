#include <gtest/gtest.h>
#include <zstd.h>

#include <cmath>
#include <fstream>

#include "tests/temporary_folder.hpp"
#include "tests/unit/runtime/pack_bytes.hpp"

namespace windloom::runtime {
namespace {

std::string compressed(const std::string& bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 3));
  return packed;
}

/// 32 x 32 cells of slowly changing wind.
PackBytes meadow(bool floats) {
  PackBytes bytes;
  bytes.version = 2;
  bytes.width = bytes.height = 32;
  bytes.corners[2] = bytes.corners[3] = 32;
  bytes.flags = floats ? 8 : 0;
  for (std::uint32_t i = 0; i < 32 * 32; ++i) {
    bytes.floats.push_back(static_cast<float>(i % 32));
    bytes.floats.push_back(1.0f);
    bytes.halves.push_back(i % 2 == 0 ? kTwo : kFour);
    bytes.halves.push_back(kOne);
  }
  if (!floats) bytes.floats.clear();
  if (floats) bytes.halves.clear();
  return bytes;
}

PackBytes packed(PackBytes bytes) {
  bytes.stored = compressed(bytes.cells());
  bytes.flags |= 16;
  return bytes;
}

}  // namespace

TEST(CompressedPack, SamplesAsTheOneThatIsNot) {
  const TemporaryFolder folder;
  for (const bool floats : {false, true}) {
    const std::string plainBytes = meadow(floats).build(), packedBytes = packed(meadow(floats)).build();
    EXPECT_LT(packedBytes.size() * 2, plainBytes.size());
    const WindPack plain = load(plainBytes), fromMemory = load(packedBytes);
    ASSERT_TRUE(plain);
    ASSERT_TRUE(fromMemory) << windloom_status_text(fromMemory.status());
    const std::string path = (folder.path() / "wind.windpack").string();
    std::ofstream(path, std::ios::binary) << packedBytes;
    const WindPack fromFile = WindPack::load(path);
    ASSERT_TRUE(fromFile) << windloom_status_text(fromFile.status());
    for (float x = 0.1f; x < 32.0f; x += 1.7f) {
      EXPECT_EQ(fromMemory.sample(x, 31.0f - x, 0).x, plain.sample(x, 31.0f - x, 0).x);
      EXPECT_EQ(fromFile.sample(x, 31.0f - x, 0).x, plain.sample(x, 31.0f - x, 0).x);
    }
  }
}

TEST(CompressedPack, MayBeInSeveralFrames) {
  PackBytes bytes = meadow(false);
  const std::string cells = bytes.cells();
  bytes.stored = compressed(cells.substr(0, 1000)) + compressed(cells.substr(1000));
  bytes.flags |= 16;
  EXPECT_TRUE(load(bytes.build()));
}

TEST(CompressedPack, RefusesOtherSizesThanTheHeaderSays) {
  PackBytes bytes = packed(meadow(false));
  for (const std::size_t size : {0u, 1u, 4095u, 4097u, 100'000u}) {
    bytes.stored = compressed(std::string(size, '\0'));
    EXPECT_EQ(load(bytes.build()).status(), WINDLOOM_DAMAGED) << size;
  }
  bytes.stored = compressed(std::string(4096, '\0'));
  EXPECT_EQ(load(bytes.build()).status(), WINDLOOM_OK);
  bytes.stored = "no zstd at all, though the checksum is right";
  EXPECT_EQ(load(bytes.build()).status(), WINDLOOM_DAMAGED);
  bytes.stored = compressed(std::string(4096, '\xff'));
  EXPECT_EQ(load(bytes.build()).status(), WINDLOOM_DAMAGED) << "no numbers";
}

TEST(CompressedPack, RefusesSizesThatNothingPacksTo) {
  PackBytes bytes = packed(meadow(false));
  bytes.width = bytes.height = 8192;
  bytes.frames = 60;
  EXPECT_EQ(load(bytes.build()).status(), WINDLOOM_CUT_SHORT) << "16 GiB in a hundred bytes";
  bytes = packed(meadow(false));
  bytes.stored += std::string(10'000, 'x');
  EXPECT_EQ(load(bytes.build()).status(), WINDLOOM_CUT_SHORT) << "more than zstd ever makes of so few";
}

TEST(CompressedPack, RefusesEveryCutAndEveryFlippedByte) {
  const std::string good = packed(meadow(true)).build();
  for (std::size_t length = 0; length < good.size(); ++length) EXPECT_FALSE(load(good.substr(0, length))) << length;
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string bad = good;
    bad[i] = static_cast<char>(bad[i] ^ 0x40);
    EXPECT_FALSE(load(bad)) << i;
  }
}

/// Damage that the checksum doesn't show, as someone would make it who means harm.
TEST(CompressedPack, SurvivesDamagedDataWithARightChecksum) {
  const std::string good = packed(meadow(true)).build();
  int accepted = 0;
  for (std::size_t i = 96; i < good.size() - 4; ++i) {
    for (const int change : {1, 0x40, 0xff}) {
      std::string bad = good;
      bad[i] = static_cast<char>(bad[i] ^ change);
      const std::uint32_t checksum = windloom_checksum(0, bad.data(), bad.size() - 4);
      std::memcpy(bad.data() + bad.size() - 4, &checksum, 4);
      const WindPack pack = load(bad);
      if (!pack) continue;
      ++accepted;
      EXPECT_TRUE(std::isfinite(pack.sample(3.3f, 4.4f, 0).x)) << i;
    }
  }
  EXPECT_GT(accepted, 0);
}

}  // namespace windloom::runtime
