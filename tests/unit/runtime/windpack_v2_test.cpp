#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>

#include "tests/temporary_folder.hpp"
#include "tests/unit/runtime/pack_bytes.hpp"

namespace windloom::runtime {
namespace {

windloom_status statusOf(const std::function<void(PackBytes&)>& change) {
  PackBytes pack = twoByTwoFloats();
  change(pack);
  return load(pack.build()).status();
}

}  // namespace

TEST(WindPackVersion2, SaysWhatTheHeaderSays) {
  PackBytes bytes = twoByTwo();
  bytes.version = 2;
  bytes.quantity = 1;
  bytes.referenceHeight = 3;
  bytes.roughness = 0.1f;
  const WindPack pack = load(bytes.build());
  ASSERT_TRUE(pack);
  EXPECT_EQ(pack.info().quantity, 1);
  EXPECT_EQ(pack.info().reference_height, 3.0f);
  EXPECT_EQ(pack.info().roughness, 0.1f);
  EXPECT_EQ(pack.sample(1.0f, 1.0f, 0).x, 1.75f);
}

TEST(WindPackVersion2, OlderPacksHoldWindWithoutAProfile) {
  const WindPack pack = load(twoByTwo().build());
  ASSERT_TRUE(pack);
  EXPECT_EQ(pack.info().quantity, 0);
  EXPECT_EQ(pack.info().roughness, 0.0f);
  EXPECT_GT(pack.info().reference_height, 0.0f);
  EXPECT_EQ(pack.heightFactor(0.0f), 1.0f);
  EXPECT_EQ(pack.heightFactor(50.0f), 1.0f);
}

TEST(WindPackVersion2, InterpolatesFloats) {
  const WindPack pack = load(twoByTwoFloats().build());
  ASSERT_TRUE(pack);
  EXPECT_EQ(pack.sample(0.5f, 0.5f, 0).x, 0.0f);
  EXPECT_EQ(pack.sample(1.5f, 1.5f, 0).x, 4.0f);
  EXPECT_EQ(pack.sample(1.0f, 1.0f, 0).x, 1.75f);
  EXPECT_EQ(pack.sample(1.0f, 1.0f, 0).z, -1.0f);
}

TEST(WindPackVersion2, KeepsEveryDigitOfAFloat) {
  PackBytes bytes = twoByTwoFloats();
  bytes.maxSpeed = 1e9f;
  bytes.floats = {1.2345678f, -1e-30f, 1e9f, 0.1f, 3, 4, 5, 6};
  const WindPack pack = load(bytes.build());
  ASSERT_TRUE(pack);
  EXPECT_EQ(pack.sample(0.5f, 0.5f, 0).x, 1.2345678f);
  EXPECT_EQ(pack.sample(0.5f, 0.5f, 0).z, -1e-30f);
  EXPECT_EQ(pack.sample(1.5f, 0.5f, 0).x, 1e9f);
}

TEST(WindPackVersion2, WeakensTheWindTowardsTheGround) {
  PackBytes bytes = twoByTwoFloats();
  bytes.referenceHeight = 2;
  bytes.roughness = 0.03f;
  const WindPack pack = load(bytes.build());
  ASSERT_TRUE(pack);
  EXPECT_EQ(pack.heightFactor(-1.0f), 0.0f);
  EXPECT_EQ(pack.heightFactor(0.0f), 0.0f);
  EXPECT_FLOAT_EQ(pack.heightFactor(2.0f), 1.0f);
  EXPECT_NEAR(pack.heightFactor(0.5f), std::log(1 + 0.5 / 0.03) / std::log(1 + 2 / 0.03), 1e-6);
  EXPECT_NEAR(pack.heightFactor(8.0f), std::log(1 + 8 / 0.03) / std::log(1 + 2 / 0.03), 1e-6);
  EXPECT_EQ(pack.heightFactor(std::numeric_limits<float>::quiet_NaN()), 0.0f);
}

TEST(WindPackVersion2, RefusesHeadersThatMakeNoSense) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(statusOf([](PackBytes&) {}), WINDLOOM_OK);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.flags |= 32; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.reserved = 1; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.reserved2 = 1; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.quantity = 2; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.referenceHeight = 0; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([=](PackBytes& p) { p.referenceHeight = nan; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.roughness = -0.1f; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.roughness = 1e-30f; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([=](PackBytes& p) { p.roughness = nan; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([=](PackBytes& p) { p.floats[3] = nan; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.floats[0] = -std::numeric_limits<float>::infinity(); }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.dataBytes = 16; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.version = 1; }), WINDLOOM_DAMAGED) << "version 1 has no floats";
}

TEST(WindPackVersion2, SaysWhichLibraryReadsACompressedPack) {
  PackBytes bytes = twoByTwo();
  bytes.version = 2;
  bytes.flags = 16;
  bytes.stored = "packed";
  const WindPack pack = load(bytes.build());
  EXPECT_FALSE(pack);
  EXPECT_EQ(pack.status(), WINDLOOM_NEEDS_ZSTD);
  EXPECT_NE(std::string(windloom_status_text(pack.status())).find("windloom_runtime_zstd"), std::string::npos);
}

TEST(WindPackVersion2, LoadsFromAFileWhatItLoadsFromMemory) {
  const TemporaryFolder folder;
  for (PackBytes bytes : {twoByTwo(), twoByTwoFloats()}) {
    const std::string path = (folder.path() / "wind.windpack").string();
    std::ofstream(path, std::ios::binary) << bytes.build();
    const WindPack pack = WindPack::load(path);
    ASSERT_TRUE(pack) << windloom_status_text(pack.status());
    EXPECT_EQ(pack.sample(1.5f, 1.5f, 0).x, 4.0f);
    std::ofstream(path, std::ios::binary) << bytes.build().substr(0, 97);
    EXPECT_EQ(WindPack::load(path).status(), WINDLOOM_CUT_SHORT);
  }
  EXPECT_EQ(WindPack::load(folder.path().string()).status(), WINDLOOM_CANNOT_READ) << "a folder";
}

TEST(WindPack, RefusesEveryCutAndEveryFlippedByte) {
  PackBytes second = twoByTwo();
  second.version = 2;
  second.roughness = 0.03f;
  for (const PackBytes& bytes : {twoByTwo(), second, twoByTwoFloats()}) {
    const std::string good = bytes.build();
    ASSERT_EQ(load(good).status(), WINDLOOM_OK);
    for (std::size_t length = 0; length < good.size(); ++length) {
      EXPECT_FALSE(load(good.substr(0, length))) << length;
    }
    EXPECT_EQ(load(good + '\0').status(), WINDLOOM_CUT_SHORT);
    for (std::size_t i = 0; i < good.size(); ++i) {
      std::string bad = good;
      bad[i] = static_cast<char>(bad[i] ^ 0x40);
      EXPECT_FALSE(load(bad)) << i;
    }
  }
}

/// Every value of every byte of the header, with a right checksum: what is accepted can be sampled.
TEST(WindPack, SurvivesEveryHeaderByte) {
  int accepted = 0;
  for (const PackBytes& bytes : {twoByTwo(), twoByTwoFloats()}) {
    const std::string good = bytes.build();
    const std::size_t header = bytes.version == 1 ? 80 : 96;
    for (std::size_t i = 0; i < header; ++i) {
      for (int value = 0; value < 256; ++value) {
        std::string other = good;
        other[i] = static_cast<char>(value);
        const std::uint32_t checksum = windloom_checksum(0, other.data(), other.size() - 4);
        std::memcpy(other.data() + other.size() - 4, &checksum, 4);
        const WindPack pack = load(other);
        if (!pack) continue;
        ++accepted;
        const Velocity v = pack.sample(0.7f, 1.9f, 0.33);
        EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.z)) << i << " " << value;
        EXPECT_TRUE(std::isfinite(pack.heightFactor(1.0f))) << i << " " << value;
      }
    }
  }
  EXPECT_GT(accepted, 2000) << "bounds, times and flags have many good values";
}

}  // namespace windloom::runtime
