// Where shells stand: the least error, by trying all in small cases and against even ones in large ones.
#include "engine/grass/shell_placing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <numbers>

namespace windloom {
namespace {

struct Bend {
  float limit = 1.0f, stiffness = 1.0f;
};
constexpr Bend kBends[] = {{1.0f, 1.0f}, {1.0f, 0.4f}, {1.0f, 2.5f}, {2.0f, 1.0f}, {0.3f, 1.0f}, {2.0f, 3.0f}};

/// How far a straight line from end `lower` to `upper` is off a blade of `segments` at most; by itself, in double.
double offStraight(int segments, int lower, int upper, Bend bend) {
  double most = 0;
  for (int k = 1; k <= 16; ++k) {
    std::vector<glm::dvec2> ends{{0.0, 0.0}};
    for (int j = 1; j <= segments; ++j) {
      const double lean = std::pow(static_cast<double>(j) / segments, static_cast<double>(bend.stiffness)) * 0.5 *
                          std::numbers::pi * static_cast<double>(bend.limit) * k / 16.0;
      ends.push_back(ends.back() + glm::dvec2(std::cos(lean), std::sin(lean)) / static_cast<double>(segments));
    }
    const auto at = [&](int i) { return ends[static_cast<std::size_t>(i)]; };
    for (int i = lower; i <= upper; ++i) {
      const double part = static_cast<double>(i - lower) / (upper - lower);
      most = std::max(most, glm::distance(at(i), glm::mix(at(lower), at(upper), part)));
    }
  }
  return most;
}

double errorOf(const std::vector<int>& ends, int segments, Bend bend, const std::vector<float>& reaching = {}) {
  double most = 0;
  int lower = 0;
  for (const int end : ends) {
    double weight = 1;
    if (!reaching.empty()) {
      const double at = static_cast<double>(lower) / segments * static_cast<double>(reaching.size() - 1);
      const auto low = static_cast<std::size_t>(at), high = std::min(low + 1, reaching.size() - 1);
      weight = std::lerp(static_cast<double>(reaching[low]), static_cast<double>(reaching[high]),
                         at - static_cast<double>(low));
    }
    most = std::max(most, weight * offStraight(segments, lower, end, bend));
    lower = end;
  }
  return most;
}

/// As a meadow's: all blades reach low, none to the top.
std::vector<float> falling() {
  std::vector<float> reaching;
  for (int i = 0; i < 64; ++i) reaching.push_back(0.5f * std::max(1.0f - static_cast<float>(i) / 58.0f, 0.0f));
  return reaching;
}

/// The least error of all ways to choose `shells` of `segments` ends with the last one, by trying them.
double leastByTrying(int segments, int shells, Bend bend, const std::vector<float>& reaching) {
  double least = 1e9;
  for (unsigned mask = 0; mask < 1u << (segments - 1); ++mask) {
    if (std::popcount(mask) != shells - 1) continue;
    std::vector<int> ends;
    for (int end = 1; end < segments; ++end) {
      if ((mask >> (end - 1) & 1u) != 0) ends.push_back(end);
    }
    ends.push_back(segments);
    least = std::min(least, errorOf(ends, segments, bend, reaching));
  }
  return least;
}

TEST(ShellPlacing, IsTheBestOfAllThatThereAre) {
  for (const Bend bend : kBends) {
    for (const std::vector<float>& reaching : {std::vector<float>{}, falling()}) {
      for (const int shells : {1, 2, 3, 5}) {
        const ShellPlacing placing = placeShells(10, shells, bend.limit, bend.stiffness, reaching);
        ASSERT_EQ(placing.ends.size(), static_cast<std::size_t>(shells));
        EXPECT_NEAR(errorOf(placing.ends, 10, bend, reaching), leastByTrying(10, shells, bend, reaching), 1e-6)
            << shells << " shells, limit " << bend.limit << ", stiffness " << bend.stiffness;
      }
    }
  }
}

TEST(ShellPlacing, SaysItsLargestError) {
  for (const Bend bend : kBends) {
    for (const int shells : {1, 3, 8}) {
      const ShellPlacing placed = placeShells(64, shells, bend.limit, bend.stiffness, falling());
      EXPECT_NEAR(placed.error, errorOf(placed.ends, 64, bend), 1e-5);
      const ShellPlacing even = evenShells(64, shells, bend.limit, bend.stiffness);
      EXPECT_NEAR(even.error, errorOf(even.ends, 64, bend), 1e-5);
    }
  }
}

TEST(ShellPlacing, MoreShellsAreNeverWorseAndNeverWorseThanEvenOnes) {
  for (const Bend bend : kBends) {
    float plainBefore = 1.0f;
    double weightedBefore = 1.0;
    for (const int shells : {1, 2, 3, 4, 6, 8, 12, 16, 32, 64}) {
      const ShellPlacing plain = placeShells(64, shells, bend.limit, bend.stiffness, {});
      const ShellPlacing even = evenShells(64, shells, bend.limit, bend.stiffness);
      EXPECT_LE(plain.error, plainBefore + 1e-6f) << shells << " shells";
      EXPECT_LE(plain.error, even.error + 1e-6f) << shells << " shells";
      const ShellPlacing weighted = placeShells(64, shells, bend.limit, bend.stiffness, falling());
      const double error = errorOf(weighted.ends, 64, bend, falling());
      EXPECT_LE(error, weightedBefore + 1e-6) << shells << " shells";
      EXPECT_LE(error, errorOf(even.ends, 64, bend, falling()) + 1e-6) << shells << " shells";
      plainBefore = plain.error;
      weightedBefore = error;
    }
    EXPECT_LT(plainBefore, 1e-6f) << "a shell at every end";
  }
}

TEST(ShellPlacing, StandsCloserWhereBladesBend) {
  // Stiff blades bend near their tips, floppy ones near their roots.
  const ShellPlacing stiff = placeShells(64, 6, 1.0f, 3.0f, {}), floppy = placeShells(64, 6, 1.0f, 0.25f, {});
  EXPECT_GT(stiff.ends.front(), 64 / 6 + 4);
  EXPECT_LT(floppy.ends.front(), 64 / 6 - 4);
  EXPECT_LT(stiff.error, 0.8f * evenShells(64, 6, 1.0f, 3.0f).error);
}

TEST(ShellPlacing, LeavesOutHeightsThatNoBladeReaches) {
  std::vector<float> reaching(64, 1.0f);
  for (std::size_t i = 24; i < 64; ++i) reaching[i] = 0.0f;
  const ShellPlacing placing = placeShells(64, 6, 1.0f, 1.0f, reaching);
  EXPECT_EQ(placing.ends.back(), 64);
  EXPECT_GE(std::ranges::count_if(placing.ends, [](int end) { return end <= 26; }), 4);
}

TEST(ShellPlacing, CoarserOnesCanBeChosenAmongFinerOnes) {
  const std::vector<float> reaching = falling();
  const ShellPlacing fine = placeShells(64, 12, 1.0f, 1.0f, reaching);
  std::vector<int> among = fine.ends;
  for (const int shells : {6, 3, 2, 1}) {
    const ShellPlacing coarse = placeShells(64, shells, 1.0f, 1.0f, reaching, among);
    ASSERT_EQ(coarse.ends.size(), static_cast<std::size_t>(shells));
    EXPECT_TRUE(std::ranges::includes(among, coarse.ends));
    EXPECT_GE(errorOf(coarse.ends, 64, {}, reaching),
              errorOf(placeShells(64, shells, 1.0f, 1.0f, reaching).ends, 64, {}, reaching) - 1e-6);
    among = coarse.ends;
  }
  const ShellPlacing all = placeShells(64, 50, 1.0f, 1.0f, reaching, fine.ends);
  EXPECT_EQ(all.ends, fine.ends) << "no more than there are";
  const int few[] = {7, 20};
  EXPECT_EQ(placeShells(64, 9, 1.0f, 1.0f, {}, few).ends, (std::vector<int>{7, 20, 64})) << "the last always";
}

TEST(ShellPlacing, EvenShellsAreEven) {
  EXPECT_EQ(evenShells(64, 4, 1.0f, 1.0f).ends, (std::vector<int>{16, 32, 48, 64}));
  EXPECT_EQ(evenShells(64, 1, 1.0f, 1.0f).ends, std::vector<int>{64});
  for (const int shells : {3, 7, 31, 63, 64, 200}) {
    const std::vector<int> ends = evenShells(64, shells, 1.0f, 1.0f).ends;
    ASSERT_EQ(ends.size(), static_cast<std::size_t>(std::min(shells, 64)));
    EXPECT_EQ(ends.back(), 64);
    int before = 0;
    for (const int end : ends) {
      EXPECT_NEAR(end - before, 64.0 / static_cast<double>(ends.size()), 1.0);
      EXPECT_GT(end, before);
      before = end;
    }
  }
}

TEST(ShellPlacing, EndsAscendFromTheGroundToTheTip) {
  for (const Bend bend : kBends) {
    for (int shells = 1; shells <= 64; shells += 7) {
      const std::vector<int> ends = placeShells(64, shells, bend.limit, bend.stiffness, falling()).ends;
      ASSERT_EQ(ends.size(), static_cast<std::size_t>(shells));
      EXPECT_GE(ends.front(), 1);
      EXPECT_EQ(ends.back(), 64);
      EXPECT_TRUE(std::ranges::is_sorted(ends, std::ranges::less_equal{}));
    }
  }
}

}  // namespace
}  // namespace windloom
