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

TEST(Half, IsReadBackAsItsValue) {
  for (std::uint32_t half = 0; half <= 0x7bff; ++half) {
    ASSERT_EQ(floatFromHalf(static_cast<std::uint16_t>(half)), valueOf(half));
    ASSERT_EQ(floatFromHalf(static_cast<std::uint16_t>(half | 0x8000)), -valueOf(half));
  }
}

TEST(Half, StaysFiniteBeyondItsRange) {
  EXPECT_EQ(halfFromFloat(65504.0f), 0x7bff);
  EXPECT_EQ(halfFromFloat(70000.0f), 0x7bff);
  EXPECT_EQ(halfFromFloat(-std::numeric_limits<float>::infinity()), 0xfbff);
}

class WindpackWriter : public testing::Test {
 protected:
  WindpackWriter() {
    m_header.grid = makeGridMapping({5, -2}, {12, 8}, {6, 4});
    m_header.frames = 3;
    m_header.last = 2;
    m_header.fps = 12;
    m_header.start = 1.5;
    m_header.loop = true;
    m_header.periodicZ = true;
    m_header.fastest = 42;
    m_header.profile.reference = 3;
    m_header.profile.roughness = 0.1f;
  }

  static glm::vec2 velocityOf(int frame, int i, int k) {
    return {static_cast<float>(frame) * 10 + static_cast<float>(i) * 0.5f, static_cast<float>(-k) * 0.25f + 0.0001f};
  }

  /// Writes all frames; the one file.
  BakedFile writeAll(std::string_view kind) {
    Result<std::unique_ptr<FrameWriter>> writer = writerKindNamed(kind)->open(m_header, m_folder.path());
    EXPECT_TRUE(writer) << writer.error().text();
    for (int frame = 0; frame < 3; ++frame) {
      std::vector<glm::vec2> field;
      for (int k = 0; k < 4; ++k) {
        for (int i = 0; i < 6; ++i) field.push_back(velocityOf(frame, i, k));
      }
      EXPECT_TRUE((*writer)->add(frame, field));
    }
    Result<std::vector<BakedFile>> files = (*writer)->finish();
    EXPECT_TRUE(files);
    EXPECT_EQ(files->size(), 1u);
    return files->at(0);
  }

  std::uint64_t sizeOf(const BakedFile& file) { return std::filesystem::file_size(m_folder.path() / file.path); }

  runtime::WindPack load(const BakedFile& file) {
    return runtime::WindPack::load((m_folder.path() / file.path).string());
  }

  void expectValues(const runtime::WindPack& pack, float tolerance) {
    for (int k = 0; k < 4; ++k) {
      for (int i = 0; i < 6; ++i) {
        const glm::vec2 centre = cellCentreToWorld(glm::vec2(i, k), m_header.grid.minCorner, m_header.grid.cellSize);
        const runtime::Velocity v = pack.sample(centre.x, centre.y, 1.0 / 12.0);
        EXPECT_NEAR(v.x, velocityOf(1, i, k).x, tolerance);
        EXPECT_NEAR(v.z, velocityOf(1, i, k).y, tolerance);
      }
    }
  }

  BakeHeader m_header;
  TemporaryFolder m_folder;
};

TEST_F(WindpackWriter, WritesWhatTheRuntimeLoads) {
  const BakedFile file = writeAll("windpack");
  EXPECT_EQ(file.path, "wind.windpack");
  EXPECT_EQ(file.encoding, "half");
  EXPECT_EQ(m_folder.entries(), 1);
  EXPECT_EQ(sizeOf(file), writerKindNamed("windpack")->bytes(m_header));
  const runtime::WindPack pack = load(file);
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
  EXPECT_EQ(info.quantity, 0);
  EXPECT_EQ(info.reference_height, 3.0f);
  EXPECT_EQ(info.roughness, 0.1f);
  EXPECT_NEAR(pack.heightFactor(0.7f), m_header.profile.at(0.7f), 1e-6f);
  expectValues(pack, 2e-4f);
}

TEST_F(WindpackWriter, WritesFloatsToTheLastDigit) {
  const BakedFile file = writeAll("windpack-f32");
  EXPECT_EQ(file.path, "wind-f32.windpack");
  EXPECT_EQ(file.encoding, "float32");
  EXPECT_EQ(sizeOf(file), writerKindNamed("windpack-f32")->bytes(m_header));
  const runtime::WindPack pack = load(file);
  ASSERT_TRUE(pack) << windloom_status_text(pack.status());
  expectValues(pack, 2e-6f);
}

TEST_F(WindpackWriter, WritesCompressedPacks) {
  const WriterKind* kind = writerKindNamed("windpack-zstd");
  const BakedFile file = writeAll("windpack-zstd");
  EXPECT_EQ(file.path, "wind-zstd.windpack");
  EXPECT_EQ(file.details["compression"], "zstd");
  EXPECT_LT(sizeOf(file), kind->bytes(m_header) - 50);
  EXPECT_EQ(load(file).status(), WINDLOOM_NEEDS_ZSTD) << "the library without zstd; the one with it has its own tests";
}

TEST_F(WindpackWriter, SaysThatAResponseIsNoWind) {
  m_header.track = {.name = "bend-soft", .quantity = Quantity::Bend};
  for (const char* kind : {"windpack", "windpack-f32"}) {
    const BakedFile file = writeAll(kind);
    EXPECT_TRUE(file.path.starts_with("bend-soft-wind")) << file.path;
    const runtime::WindPack pack = load(file);
    ASSERT_TRUE(pack);
    EXPECT_EQ(pack.info().quantity, 1);
    EXPECT_EQ(pack.heightFactor(0.0f), 1.0f) << "how a plant leans doesn't depend on a height";
  }
}

TEST_F(WindpackWriter, RefusesMoreThanThePackHolds) {
  m_header.grid = makeGridMapping({0, 0}, {100, 100}, {4096, 4096});
  m_header.frames = 300;
  const auto writer = writerKindNamed("windpack")->open(m_header, m_folder.path());
  ASSERT_FALSE(writer);
  EXPECT_NE(writer.error().text().find("16 GiB"), std::string::npos);
  EXPECT_EQ(writerKindNamed("windpack")->refusal(m_header), writer.error().text());
  m_header.frames = 200;
  EXPECT_EQ(writerKindNamed("windpack")->refusal(m_header), "");
  EXPECT_NE(writerKindNamed("windpack-f32")->refusal(m_header), "") << "twice as large";
  EXPECT_EQ(m_folder.entries(), 0);
}

}  // namespace windloom
