#include <gtest/gtest.h>

#include <cmath>

#include "engine/bake/frame_writer.hpp"
#include "engine/bake/half.hpp"
#include "engine/runtime/windloom_runtime.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace {

/// The value of a finite half by its definition.
float valueOf(std::uint32_t half) {
  const int exponent = static_cast<int>(half >> 10 & 0x1f);
  const auto fraction = static_cast<float>(half & 0x3ff);
  const float magnitude = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024.0f + fraction, exponent - 25);
  return (half & 0x8000) != 0 ? -magnitude : magnitude;
}

}  // namespace

TEST(Half, RoundsToTheNearest) {
  for (std::uint32_t half = 0; half < 0x7bff; ++half) {
    const float low = valueOf(half), high = valueOf(half + 1), middle = 0.5f * (low + high);
    ASSERT_EQ(halfFromFloat(low), half);
    ASSERT_EQ(halfFromFloat(-low), half | 0x8000);
    ASSERT_EQ(halfFromFloat(std::nextafter(middle, low)), half);
    ASSERT_EQ(halfFromFloat(std::nextafter(middle, high)), half + 1);
    ASSERT_EQ(halfFromFloat(middle), (half & 1) == 0 ? half : half + 1) << "ties go to even";
  }
}

TEST(Half, StaysFiniteBeyondItsRange) {
  EXPECT_EQ(halfFromFloat(65504.0f), 0x7bff);
  EXPECT_EQ(halfFromFloat(70000.0f), 0x7bff);
  EXPECT_EQ(halfFromFloat(-std::numeric_limits<float>::infinity()), 0xfbff);
}

TEST(WindpackWriter, WritesWhatTheRuntimeLoads) {
  const TemporaryFolder folder;
  BakeHeader header;
  header.grid = makeGridMapping({5, -2}, {12, 8}, {6, 4});
  header.frames = 3;
  header.fps = 12;
  header.start = 1.5;
  header.loop = true;
  header.periodicZ = true;
  header.fastest = 42;
  Result<std::unique_ptr<FrameWriter>> writer = writerKindNamed("windpack")->open(header, folder.path());
  ASSERT_TRUE(writer) << writer.error().text();
  const auto velocityOf = [](int frame, int i, int k) {
    return glm::vec2(static_cast<float>(frame) * 10 + static_cast<float>(i) * 0.5f, static_cast<float>(-k) * 0.25f);
  };
  for (int frame = 0; frame < 3; ++frame) {
    std::vector<glm::vec2> field;
    for (int k = 0; k < 4; ++k) {
      for (int i = 0; i < 6; ++i) field.push_back(velocityOf(frame, i, k));
    }
    ASSERT_TRUE((*writer)->add(frame, field));
  }
  EXPECT_EQ(folder.entries(), 1);
  const Result<std::vector<BakedFile>> files = (*writer)->finish();
  ASSERT_TRUE(files);
  const auto pack = runtime::WindPack::load((folder.path() / files->at(0).path).string());
  ASSERT_TRUE(pack) << windloom_status_text(pack.status());
  const windloom_info info = pack.info();
  EXPECT_EQ(info.width, 6);
  EXPECT_EQ(info.height, 4);
  EXPECT_EQ(info.frames, 3);
  EXPECT_EQ(info.min_x, -1.0f);
  EXPECT_EQ(info.max_z, 2.0f);
  EXPECT_EQ(info.fps, 12.0f);
  EXPECT_EQ(info.max_speed, 42.0f);
  EXPECT_EQ(info.start, 1.5);
  EXPECT_EQ(info.loop, 1);
  EXPECT_EQ(info.edge_x, WINDLOOM_CLAMP);
  EXPECT_EQ(info.edge_z, WINDLOOM_WRAP);
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i < 6; ++i) {
      const glm::vec2 centre = cellCentreToWorld(glm::vec2(i, k), header.grid.minCorner, header.grid.cellSize);
      const runtime::Velocity v = pack.sample(centre.x, centre.y, 1.0 / 12.0);
      EXPECT_NEAR(v.x, velocityOf(1, i, k).x, 1e-4f);
      EXPECT_NEAR(v.z, velocityOf(1, i, k).y, 1e-4f);
    }
  }
}

TEST(WindpackWriter, RefusesMoreThanThePackHolds) {
  const TemporaryFolder folder;
  BakeHeader header;
  header.grid = makeGridMapping({0, 0}, {100, 100}, {4096, 4096});
  header.frames = 300;
  const auto writer = writerKindNamed("windpack")->open(header, folder.path());
  ASSERT_FALSE(writer);
  EXPECT_NE(writer.error().text().find("16 GiB"), std::string::npos);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace windloom
