// The sums that bend shell grass (shaders/shared/shell_bend.h), against closed forms and direct sums.
#include "shaders/shared/shell_bend.h"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>
#include <vector>

#include "engine/grass/shell_placing.hpp"

namespace windloom {
namespace {

using shared::shellIntensity;
using shared::ShellOffset;

constexpr double kHalfPi = std::numbers::pi / 2;
constexpr float kStiffnesses[] = {0.25f, 0.5f, 1.0f, 1.7f, 4.0f};
constexpr int kSegments[] = {1, 2, 9, 33, 64, 128};

/// n_i and w_i in heights of the blade for i = 0..segments.
std::vector<ShellOffset> runningTotal(int segments, float intensity, float stiffness) {
  std::vector<ShellOffset> offsets{{0.0f, 0.0f}};
  for (int i = 1; i <= segments; ++i) {
    offsets.push_back(
        shared::shellNext(offsets.back(), i, segments, 1.0f / static_cast<float>(segments), intensity, stiffness));
  }
  return offsets;
}

std::vector<float> intensities(float limit) {
  std::vector<float> list;
  for (int k = -20; k <= 20; ++k) list.push_back(limit * static_cast<float>(k) / 20.0f);
  return list;
}

/// rad that a segment leans by.
double leanOf(ShellOffset from, ShellOffset to) {
  return std::atan2(static_cast<double>(to.aside) - static_cast<double>(from.aside),
                    static_cast<double>(to.along) - static_cast<double>(from.along));
}

TEST(ShellBend, RunningTotalIsDirichletsClosedSum) {
  for (const int segments : kSegments) {
    for (const float intensity : intensities(1.0f)) {
      if (intensity == 0.0f) continue;
      const double angle = kHalfPi * static_cast<double>(intensity) / segments;
      const auto offsets = runningTotal(segments, intensity, 1.0f);
      for (int i = 0; i <= segments; ++i) {
        // The sums of cos(j angle) and sin(j angle) for j = 1..i. The paper's own begin with j = 0, which adds S to n.
        const double chord = std::sin(0.5 * i * angle) / std::sin(0.5 * angle) / segments;
        EXPECT_NEAR(offsets[static_cast<std::size_t>(i)].along, chord * std::cos(0.5 * (i + 1) * angle), 2e-6);
        EXPECT_NEAR(offsets[static_cast<std::size_t>(i)].aside, chord * std::sin(0.5 * (i + 1) * angle), 2e-6);
      }
    }
  }
}

TEST(ShellBend, RunningTotalIsTheDirectSumForAnyStiffness) {
  for (const float stiffness : kStiffnesses) {
    for (const int segments : kSegments) {
      for (const float intensity : intensities(2.0f)) {
        const auto offsets = runningTotal(segments, intensity, stiffness);
        long double along = 0, aside = 0;
        for (int i = 1; i <= segments; ++i) {
          const long double part =
              std::pow(static_cast<long double>(i) / segments, static_cast<long double>(stiffness));
          const long double lean = part * static_cast<long double>(kHalfPi) * static_cast<long double>(intensity);
          along += std::cos(lean) / segments;
          aside += std::sin(lean) / segments;
          ASSERT_NEAR(offsets[static_cast<std::size_t>(i)].along, static_cast<double>(along), 3e-6);
          ASSERT_NEAR(offsets[static_cast<std::size_t>(i)].aside, static_cast<double>(aside), 3e-6);
        }
      }
    }
  }
}

TEST(ShellBend, EverySegmentKeepsItsLength) {
  for (const float stiffness : kStiffnesses) {
    for (const int segments : kSegments) {
      for (const float limit : {1.0f, 2.0f}) {
        for (const float intensity : intensities(limit)) {
          const auto offsets = runningTotal(segments, intensity, stiffness);
          for (std::size_t i = 1; i < offsets.size(); ++i) {
            const double along = static_cast<double>(offsets[i].along) - static_cast<double>(offsets[i - 1].along);
            const double aside = static_cast<double>(offsets[i].aside) - static_cast<double>(offsets[i - 1].aside);
            ASSERT_NEAR(std::hypot(along, aside) * segments, 1.0, 1e-5)
                << segments << " segments, I " << intensity << ", stiffness " << stiffness << ", segment " << i;
          }
        }
      }
    }
  }
}

TEST(ShellBend, StandsUprightInStillAir) {
  EXPECT_EQ(shellIntensity(0.0f, 1.0f), 0.0f);
  for (const float stiffness : kStiffnesses) {
    for (const int segments : kSegments) {
      const auto offsets = runningTotal(segments, shellIntensity(0.0f, 1.0f), stiffness);
      for (std::size_t i = 0; i < offsets.size(); ++i) {
        EXPECT_EQ(offsets[i].aside, 0.0f);
        EXPECT_NEAR(offsets[i].along, static_cast<double>(i) / segments, 1e-6);
      }
    }
  }
}

TEST(ShellBend, StrongestWindLaysTheTipLevelAndNeverFurther) {
  for (const float stiffness : kStiffnesses) {
    for (const int segments : kSegments) {
      for (const float bend : {0.1f, 0.7f, 1.5f, 1.58f, 3.0f, 1e6f}) {
        const auto offsets = runningTotal(segments, shellIntensity(bend, 1.0f), stiffness);
        for (std::size_t i = 1; i < offsets.size(); ++i) {
          EXPECT_LE(leanOf(offsets[i - 1], offsets[i]), kHalfPi + 1e-4);
        }
        if (bend > 1.57f) {
          EXPECT_NEAR(leanOf(offsets.end()[-2], offsets.back()), kHalfPi, 1e-3) << "bend " << bend;
        }
      }
    }
  }
}

TEST(ShellBend, BendsOverTheGroundOnlyWhenAsked) {
  const auto asked = runningTotal(64, shellIntensity(1e6f, 2.0f), 1.0f);
  EXPECT_NEAR(leanOf(asked[63], asked[64]), 2.0 * kHalfPi, 1e-3) << "points down";
  EXPECT_LT(asked[64].along, asked[32].along);
  const auto usual = runningTotal(64, shellIntensity(1e6f, 1.0f), 1.0f);
  for (std::size_t i = 1; i < usual.size(); ++i) EXPECT_GE(usual[i].along, usual[i - 1].along - 1e-6f);
}

TEST(ShellBend, FloppyBladesBendLowAndStiffOnesHigh) {
  const auto leanAt = [](float stiffness) { return shared::shellLean(32, 64, 1.0f, stiffness); };
  EXPECT_GT(leanAt(0.5f), leanAt(1.0f));
  EXPECT_GT(leanAt(1.0f), leanAt(2.0f));
  for (const float stiffness : kStiffnesses) {
    EXPECT_EQ(shared::shellLean(0, 64, 1.0f, stiffness), 0.0f) << "the root is upright";
    EXPECT_NEAR(shared::shellLean(64, 64, 1.0f, stiffness), kHalfPi, 1e-6) << "the tip leans alike";
  }
}

TEST(ShellIntensity, GrowsSmoothlyToItsLimit) {
  constexpr float kStep = 1.0f / 1024.0f;
  for (const float limit : {0.3f, 1.0f, 2.0f}) {
    float before = 0.0f, slope = 4.0f / std::numbers::pi_v<float>;
    for (int k = 1; k <= 8192; ++k) {
      const float bend = kStep * static_cast<float>(k), now = shellIntensity(bend, limit);
      ASSERT_GE(now, before - 1e-6f) << "bend " << bend;
      ASSERT_LE(now, limit + 1e-6f);
      const float slopeNow = (now - before) / kStep;
      ASSERT_NEAR(slopeNow, slope, 0.01f / limit) << "bend " << bend;
      before = now;
      slope = slopeNow;
    }
    const float enough = static_cast<float>(kHalfPi) * limit;
    EXPECT_NEAR(shellIntensity(enough, limit), limit, 1e-5f);
    EXPECT_LT(shellIntensity(0.8f * enough, limit), 0.97f * limit);
    EXPECT_EQ(shellIntensity(1e9f, limit), shellIntensity(2.0f * enough, limit));
  }
}

TEST(ShellIntensity, WeakWindMovesTheTipAsTheOtherKindsOfGrass) {
  // CWD-Sim eq. 12: the tip goes by F V heights.
  for (const float bend : {0.001f, 0.005f, 0.01f, 0.02f}) {
    const auto offsets = runningTotal(SHELL_SEGMENTS, shellIntensity(bend, 1.0f), 1.0f);
    EXPECT_NEAR(offsets.back().aside, bend, 0.02f * bend);
  }
}

TEST(ShellSource, SwingsBetweenItsStrengths) {
  float least = 0.0f, most = 0.0f;
  for (int k = 0; k < 4000; ++k) {
    const float value = shared::shellSourceIntensity(0.013f * static_cast<float>(k), 0.017f * static_cast<float>(k),
                                                     0.6f, 3.0f, 1.0f, 0.12f);
    least = std::min(least, value);
    most = std::max(most, value);
  }
  EXPECT_GE(least, -0.6f);
  EXPECT_LE(most, 0.6f);
  EXPECT_LT(least, -0.59f);
  EXPECT_GT(most, 0.59f);
}

TEST(ShellSource, RingsSwingAlikeAndEachLater) {
  const auto at = [](float away, float time) {
    return shared::shellSourceIntensity(away, time, 0.8f, 2.5f, 1.5f, 0.25f);
  };
  for (const float time : {0.0f, 0.4f, 1.0f, 2.2f, 7.75f}) {
    EXPECT_NEAR(at(2.0f, time), at(2.0f, time + 2.5f), 1e-4f) << "periodic";
    for (int ring = 0; ring < 12; ++ring) {
      const float inner = 1.5f * static_cast<float>(ring);
      EXPECT_EQ(at(inner + 0.01f, time), at(inner + 1.49f, time)) << "one step of animation";
      EXPECT_NEAR(at(inner + 1.6f, time + 0.25f), at(inner + 0.1f, time), 1e-5f) << "a delay later";
      EXPECT_NEAR(at(inner + 0.1f, time),
                  0.8f * std::sin(2.0f * std::numbers::pi_v<float> * (time - 0.25f * static_cast<float>(ring)) / 2.5f),
                  1e-4f);
    }
  }
}

TEST(ShellHeightCurve, AlphaAndHeightAreInverse) {
  for (const float curve : {1.0f, 1.5f, 2.0f, 4.0f}) {
    for (int code = 0; code <= 255; ++code) {
      const float alpha = static_cast<float>(code) / 255.0f, height = shared::shellHeightOf(alpha, curve);
      EXPECT_GE(height, 0.0f);
      EXPECT_LE(height, 1.0f);
      EXPECT_NEAR(shared::shellHeightOf(shared::shellAlphaOf(height, curve), curve), height, 1e-6f);
      // One minus a number of 24 bits tells heights apart that are more than 1e-6 below the top.
      if (height > 1.0f - 1e-6f && code < 255) continue;
      EXPECT_NEAR(shared::shellAlphaOf(height, curve), alpha, 0.3f / 255.0f) << "code " << code << ", curve " << curve;
    }
    EXPECT_EQ(shared::shellHeightOf(0.0f, curve), 0.0f);
    EXPECT_EQ(shared::shellHeightOf(1.0f, curve), 1.0f);
  }
  // Finer near the top: the last code's step is smaller than the first's.
  const auto step = [](int code) {
    const auto at = [](int c) { return shared::shellHeightOf(static_cast<float>(c) / 255.0f, 2.0f); };
    return at(code) - at(code - 1);
  };
  EXPECT_LT(10.0f * step(255), step(1));
}

TEST(ShellOffsetTable, HoldsARowForEachIntensity) {
  const std::vector<glm::vec2> table = shellOffsetTable(64, 9, 1.5f, 1.3f);
  ASSERT_EQ(table.size(), 9u * 65u);
  for (std::size_t row = 0; row < 9; ++row) {
    const auto offsets = runningTotal(64, 1.5f * static_cast<float>(row) / 8.0f, 1.3f);
    for (std::size_t i = 0; i <= 64; ++i) {
      EXPECT_NEAR(table[row * 65 + i].x, offsets[i].along, 1e-6f);
      EXPECT_NEAR(table[row * 65 + i].y, offsets[i].aside, 1e-6f);
    }
  }
  for (std::size_t i = 0; i <= 64; ++i) {
    EXPECT_EQ(table[i], glm::vec2(static_cast<float>(i) / 64.0f, 0.0f)) << "still air";
  }
  const auto against = runningTotal(64, -1.5f, 1.3f);
  EXPECT_NEAR(against[64].along, table[8 * 65 + 64].x, 1e-6f);
  EXPECT_NEAR(against[64].aside, -table[8 * 65 + 64].y, 1e-6f);
  EXPECT_EQ(shellOffsetTable(8, 1, 1.0f, 1.0f).size(), 9u);
}

}  // namespace
}  // namespace windloom
