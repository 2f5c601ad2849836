#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "tests/unit/runtime/pack_bytes.hpp"

namespace windloom::runtime {
namespace {

/// The half nearest below a number of 0..15 in steps of 1/64.
std::uint16_t halfOf(float value) {
  if (value == 0.0f) return 0;
  int exponent = 0;
  const float fraction = std::frexp(std::fabs(value), &exponent);
  const auto bits = static_cast<std::uint16_t>((exponent + 14) << 10 | (static_cast<int>(fraction * 2048.0f) & 0x3ff));
  return static_cast<std::uint16_t>(bits | (value < 0.0f ? 0x8000 : 0));
}

struct Case {
  std::uint32_t width, height, frames, flags;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.width << " x " << c.height << " x " << c.frames << " flags " << c.flags;
}

/// Numbers that a half holds exactly, in either kind of cell.
PackBytes randomPack(const Case& c) {
  PackBytes bytes;
  bytes.version = 2;
  bytes.width = c.width;
  bytes.height = c.height;
  bytes.frames = c.frames;
  bytes.flags = c.flags;
  bytes.corners[0] = -3;
  bytes.corners[1] = 1;
  bytes.corners[2] = 7;
  bytes.corners[3] = 4.5f;
  std::mt19937 random(c.width * 31 + c.height * 7 + c.frames);
  for (std::uint32_t i = 0; i < c.width * c.height * c.frames * 2; ++i) {
    const float value = static_cast<float>(static_cast<int>(random() % 1024) - 512) / 64.0f;
    if ((c.flags & 8) != 0) {
      bytes.floats.push_back(value);
    } else {
      bytes.halves.push_back(halfOf(value));
    }
  }
  return bytes;
}

float cellOf(const PackBytes& bytes, std::size_t index) {
  if (!bytes.floats.empty()) return bytes.floats[index];
  const std::uint16_t half = bytes.halves[index];
  const float magnitude = std::ldexp(static_cast<float>(0x400 | (half & 0x3ff)), (half >> 10 & 31) - 25);
  return (half & 0x7fff) == 0 ? 0.0f : (half & 0x8000) != 0 ? -magnitude : magnitude;
}

/// Neighbours along one axis by definition, in double.
void neighbours(double at, int count, bool wrap, int& low, int& high, double& weight) {
  if (wrap) {
    at -= std::floor(at / count) * count;
    low = std::min(static_cast<int>(at), count - 1);
    high = (low + 1) % count;
  } else {
    at = std::min(std::max(at, 0.0), count - 1.0);
    low = static_cast<int>(at);
    high = std::min(low + 1, count - 1);
  }
  weight = at - low;
}

Velocity expected(const PackBytes& bytes, double x, double z, double time) {
  int i[2], k[2], f[2];
  double wx, wz, wt;
  neighbours((x + 3) * bytes.width / 10 - 0.5, static_cast<int>(bytes.width), (bytes.flags & 2) != 0, i[0], i[1], wx);
  neighbours((z - 1) * bytes.height / 3.5 - 0.5, static_cast<int>(bytes.height), (bytes.flags & 4) != 0, k[0], k[1],
             wz);
  neighbours(time * 10, static_cast<int>(bytes.frames), (bytes.flags & 1) != 0, f[0], f[1], wt);
  double sum[2] = {0, 0};
  for (int n = 0; n < 8; ++n) {
    const double weight = ((n & 1) != 0 ? wx : 1 - wx) * ((n & 2) != 0 ? wz : 1 - wz) * ((n & 4) != 0 ? wt : 1 - wt);
    const auto cell =
        (static_cast<std::size_t>(f[n >> 2 & 1]) * bytes.height + static_cast<std::size_t>(k[n >> 1 & 1])) *
            bytes.width +
        static_cast<std::size_t>(i[n & 1]);
    for (std::size_t c = 0; c < 2; ++c) sum[c] += weight * static_cast<double>(cellOf(bytes, 2 * cell + c));
  }
  return {static_cast<float>(sum[0]), static_cast<float>(sum[1])};
}

/// Places inside, around and far outside the field, on its borders and where numbers end.
std::vector<float> places(std::size_t count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> x(-14.0f, 18.0f), z(-4.0f, 9.0f);
  std::vector<float> all = {-3, 1, 7, 4.5f, -2.5f, 1.25f, 6.5f, 4.25f, 6.999999f, 4.4999995f, -13, 15, 17, -6};
  while (all.size() < 2 * count) {
    all.push_back(x(random));
    all.push_back(z(random));
  }
  return all;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const std::uint32_t cells : {0u, 8u}) {
    for (std::uint32_t edges = 0; edges < 8; ++edges) {
      for (const auto& [width, height, frames] :
           {std::array{1u, 1u, 1u}, std::array{2u, 1u, 3u}, std::array{1u, 5u, 2u}, std::array{17u, 9u, 4u}}) {
        all.push_back({width, height, frames, cells | edges});
      }
    }
  }
  return all;
}

class Sampling : public testing::TestWithParam<Case> {};

}  // namespace

TEST_P(Sampling, IsLinearBetweenCellsAndFramesByDefinition) {
  const PackBytes bytes = randomPack(GetParam());
  const WindPack pack = load(bytes.build());
  ASSERT_TRUE(pack) << windloom_status_text(pack.status());
  const std::vector<float> at = places(120);
  for (const double time : {0.0, 0.137, 0.3, 0.35, 0.999, 12.345, -0.05, -7.77}) {
    for (std::size_t n = 0; n < 120; ++n) {
      const Velocity wanted = expected(bytes, static_cast<double>(at[2 * n]), static_cast<double>(at[2 * n + 1]), time);
      const Velocity found = pack.sample(at[2 * n], at[2 * n + 1], time);
      ASSERT_NEAR(found.x, wanted.x, 3e-4) << at[2 * n] << " " << at[2 * n + 1] << " " << time;
      ASSERT_NEAR(found.z, wanted.z, 3e-4) << at[2 * n] << " " << at[2 * n + 1] << " " << time;
    }
  }
}

TEST_P(Sampling, GivesBatchesTheVeryBitsOfSingleSamples) {
  const WindPack pack = load(randomPack(GetParam()).build());
  ASSERT_TRUE(pack);
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  std::vector<float> at = places(203);
  const std::vector<float> odd = {nan, 2, 3, nan, infinite, 3, -infinite, infinite, 3e38f, -3e38f, 1e20f, 1, 1e-40f, 2};
  at.insert(at.begin() + 20, odd.begin(), odd.end());
  const std::size_t count = at.size() / 2;
  for (const std::size_t many : {count, std::size_t{8}, std::size_t{7}, std::size_t{0}}) {
    for (const double time : {0.0, 0.137, 0.35, -3.21}) {
      std::vector<float> wind = at;  // in place
      windloom_sample_many(pack.view().get(), wind.data(), many, time, wind.data());
      for (std::size_t n = 0; n < many; ++n) {
        const Velocity v = pack.sample(at[2 * n], at[2 * n + 1], time);
        ASSERT_EQ(wind[2 * n], v.x) << at[2 * n] << " " << at[2 * n + 1];
        ASSERT_EQ(wind[2 * n + 1], v.z) << at[2 * n] << " " << at[2 * n + 1];
        ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.z));
      }
      for (std::size_t n = 2 * many; n < at.size(); ++n) {
        const bool kept = std::isnan(at[n]) ? std::isnan(wind[n]) : wind[n] == at[n];
        ASSERT_TRUE(kept) << "written behind the last place";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllEdgesAndCells, Sampling, testing::ValuesIn(cases()));

TEST(WindPack, OtherEdgesMayBeSetForBatchesToo) {
  WindPack pack = load(randomPack({17, 9, 2, 0}).build());
  ASSERT_TRUE(pack);
  pack.setEdges(WINDLOOM_WRAP, WINDLOOM_WRAP);
  const std::vector<float> at = places(64);
  std::vector<float> wind(at.size());
  pack.sampleMany(at.data(), 64, 0.1, wind.data());
  const PackBytes repeating = randomPack({17, 9, 2, 6});
  for (std::size_t n = 0; n < 64; ++n) {
    const Velocity v = expected(repeating, static_cast<double>(at[2 * n]), static_cast<double>(at[2 * n + 1]), 0.1);
    EXPECT_NEAR(wind[2 * n], v.x, 3e-4);
    EXPECT_NEAR(wind[2 * n + 1], v.z, 3e-4);
  }
}

}  // namespace windloom::runtime
