#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tests/unit/runtime/pack_bytes.hpp"

namespace windloom::runtime {
namespace {

windloom_status statusOf(const std::function<void(PackBytes&)>& change) {
  PackBytes pack = twoByTwo();
  change(pack);
  return load(pack.build()).status();
}

}  // namespace

TEST(WindPack, SaysWhatTheHeaderSays) {
  PackBytes bytes = twoByTwo();
  bytes.flags = 1 | 4;
  bytes.corners[0] = -1;
  bytes.start = 2.5;
  const WindPack pack = load(bytes.build());
  ASSERT_TRUE(pack);
  const windloom_info info = pack.info();
  EXPECT_EQ(info.width, 2);
  EXPECT_EQ(info.height, 2);
  EXPECT_EQ(info.frames, 1);
  EXPECT_EQ(info.min_x, -1.0f);
  EXPECT_EQ(info.max_z, 2.0f);
  EXPECT_EQ(info.fps, 10.0f);
  EXPECT_EQ(info.start, 2.5);
  EXPECT_EQ(info.loop, 1);
  EXPECT_EQ(info.edge_x, WINDLOOM_CLAMP);
  EXPECT_EQ(info.edge_z, WINDLOOM_WRAP);
}

TEST(WindPack, InterpolatesBetweenCellCentres) {
  const WindPack pack = load(twoByTwo().build());
  ASSERT_TRUE(pack);
  EXPECT_EQ(pack.sample(0.5f, 0.5f, 0).x, 0.0f);
  EXPECT_EQ(pack.sample(1.5f, 0.5f, 0).x, 1.0f);
  EXPECT_EQ(pack.sample(0.5f, 1.5f, 0).x, 2.0f);
  EXPECT_EQ(pack.sample(1.5f, 1.5f, 0).x, 4.0f);
  EXPECT_EQ(pack.sample(1.0f, 1.0f, 0).x, 1.75f);
  EXPECT_EQ(pack.sample(0.75f, 1.25f, 0).x, 0.75f * 2 * 0.75f + 0.25f * (0.25f * 1 + 0.75f * 4));
  EXPECT_EQ(pack.sample(1.0f, 1.0f, 0).z, -1.0f);
}

TEST(WindPack, ClampsOrRepeatsOutsideTheField) {
  WindPack pack = load(twoByTwo().build());
  EXPECT_EQ(pack.sample(-50.0f, -50.0f, 0).x, 0.0f);
  EXPECT_EQ(pack.sample(1e30f, 0.5f, 0).x, 1.0f);
  pack.setEdges(WINDLOOM_WRAP, WINDLOOM_CLAMP);
  EXPECT_EQ(pack.sample(2.5f, 0.5f, 0).x, 0.0f);
  EXPECT_EQ(pack.sample(-0.5f, 0.5f, 0).x, 1.0f);
  EXPECT_EQ(pack.sample(2.0f, 0.5f, 0).x, 0.5f);
  EXPECT_EQ(pack.sample(0.0f, 0.5f, 0).x, 0.5f);
  EXPECT_EQ(pack.sample(0.5f, 99.0f, 0).x, 2.0f);
}

TEST(WindPack, StaysAtItsEndsOrLoops) {
  PackBytes bytes;
  bytes.width = bytes.height = 1;
  bytes.frames = 4;
  bytes.halves = {kZero, kOne, kTwo, kOne, kFour, kOne, kEight, kOne};
  const WindPack once = load(bytes.build());
  ASSERT_TRUE(once);
  EXPECT_EQ(once.sample(1, 1, -3.0).x, 0.0f);
  EXPECT_FLOAT_EQ(once.sample(1, 1, 0.15).x, 3.0f);
  EXPECT_EQ(once.sample(1, 1, 0.3).x, 8.0f);
  EXPECT_EQ(once.sample(1, 1, 1e9).x, 8.0f);
  bytes.flags = 1;
  const WindPack loop = load(bytes.build());
  EXPECT_FLOAT_EQ(loop.sample(1, 1, 0.35).x, 4.0f);
  EXPECT_NEAR(loop.sample(1, 1, 0.4).x, 0.0f, 1e-5f);
  EXPECT_NEAR(loop.sample(1, 1, -0.05).x, 4.0f, 1e-5f);
  EXPECT_NEAR(loop.sample(1, 1, 4000.15).x, 3.0f, 1e-5f);
}

TEST(WindPack, DecodesEveryHalf) {
  PackBytes bytes;
  bytes.width = 2;
  bytes.height = 1;
  bytes.maxSpeed = 65504;
  for (std::uint32_t half = 0; half < 0x10000; ++half) {
    if ((half & 0x7c00u) == 0x7c00u) continue;
    bytes.halves = {static_cast<std::uint16_t>(half), 0, 0, 0};
    const float expected = ((half & 0x8000u) != 0 ? -1.0f : 1.0f) *
                           ((half & 0x7c00u) == 0 ? std::ldexp(static_cast<float>(half & 0x3ffu), -24)
                                                  : std::ldexp(static_cast<float>(0x400u | (half & 0x3ffu)),
                                                               static_cast<int>(half >> 10 & 0x1f) - 25));
    ASSERT_EQ(load(bytes.build()).sample(0.5f, 1.0f, 0).x, expected) << half;
  }
}

TEST(WindPack, TreatsNumbersThatAreNotFiniteAsZero) {
  const WindPack pack = load(twoByTwo().build());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(pack.sample(nan, 1.5f, 0).x, 2.0f);
  EXPECT_EQ(pack.sample(1.5f, std::numeric_limits<float>::infinity(), 0).x, 1.0f);
  EXPECT_EQ(pack.sample(1.5f, 1.5f, static_cast<double>(nan)).x, 4.0f);
}

TEST(WindPack, SamplesManyPlacesAsOne) {
  const WindPack pack = load(twoByTwo().build());
  const std::string bytes = twoByTwo().build();
  windloom_pack* c = windloom_load_memory(bytes.data(), bytes.size(), nullptr);
  ASSERT_NE(c, nullptr);
  std::vector<float> places = {0.1f, 0.9f, 1.3f, 1.1f, 1.9f, 0.2f};
  const std::vector<float> before = places;
  windloom_sample_many(c, places.data(), 3, 0.0, places.data());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(places[2 * i], pack.sample(before[2 * i], before[2 * i + 1], 0).x);
    EXPECT_EQ(places[2 * i + 1], pack.sample(before[2 * i], before[2 * i + 1], 0).z);
  }
  windloom_free(c);
}

TEST(WindPack, RefusesWhatIsNoPack) {
  EXPECT_EQ(load("").status(), WINDLOOM_NOT_A_PACK);
  EXPECT_EQ(load(std::string(500, 'x')).status(), WINDLOOM_NOT_A_PACK);
  EXPECT_EQ(load("WINDP").status(), WINDLOOM_CUT_SHORT);
  EXPECT_EQ(WindPack::load("no-such-file.windpack").status(), WINDLOOM_CANNOT_READ);
  EXPECT_EQ(WindPack::load(nullptr, 0).status(), WINDLOOM_CANNOT_READ);
}

TEST(WindPack, RefusesHeadersThatMakeNoSense) {
  EXPECT_EQ(statusOf([](PackBytes& p) { p.version = 3; }), WINDLOOM_NEWER_VERSION);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.version = 0; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.endianMark = 0x04030201; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.flags = 8; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.width = 0; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.frames = 0; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.frames = 2; }), WINDLOOM_CUT_SHORT);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.dataBytes = 12; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.corners[2] = p.corners[0]; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.corners[1] = std::numeric_limits<float>::quiet_NaN(); }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.fps = 0; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.start = std::numeric_limits<double>::infinity(); }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.halves[3] = 0x7c00; }), WINDLOOM_DAMAGED);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.halves[2] = 0xfe00; }), WINDLOOM_DAMAGED);
}

TEST(WindPack, RefusesAbsurdSizesBeforeTakingMemory) {
  EXPECT_EQ(statusOf([](PackBytes& p) { p.width = 0xffffffff; }), WINDLOOM_TOO_LARGE);
  EXPECT_EQ(statusOf([](PackBytes& p) { p.frames = 100001; }), WINDLOOM_TOO_LARGE);
  EXPECT_EQ(statusOf([](PackBytes& p) {
              p.width = p.height = 8192;
              p.frames = 65;
            }),
            WINDLOOM_TOO_LARGE);
  // Within the limits, but there is nothing behind the header.
  EXPECT_EQ(statusOf([](PackBytes& p) {
              p.width = p.height = 8192;
              p.frames = 60;
            }),
            WINDLOOM_CUT_SHORT);
}

}  // namespace windloom::runtime
