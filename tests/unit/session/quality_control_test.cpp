#include "engine/session/quality_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace windloom {
namespace {

/// Frames of a machine whose frame costs `fixedMs` plus `grassMs` at full detail; the last `watch` details' range.
struct Range {
  float low, high;
};
Range run(QualityControl& quality, double fixedMs, double grassMs, int frames, int watch) {
  Range range{1.0f, 0.0f};
  for (int i = 0; i < frames; ++i) {
    quality.frameDone(fixedMs + grassMs * static_cast<double>(quality.detail()));
    if (i < frames - watch) continue;
    range.low = std::min(range.low, quality.detail());
    range.high = std::max(range.high, quality.detail());
  }
  return range;
}

TEST(QualityControl, KeepsFullDetailOnAFastMachine) {
  QualityControl quality;
  run(quality, 2.0, 6.0, 500, 1);
  EXPECT_EQ(quality.detail(), 1.0f);
}

TEST(QualityControl, ReachesItsTargetOnASlowMachine) {
  QualityControl quality(kSoftwareFrameTargetMs);
  run(quality, 20.0, 400.0, 600, 1);
  const double frame = 20.0 + 400.0 * static_cast<double>(quality.detail());
  EXPECT_LT(frame, 1.1 * kSoftwareFrameTargetMs);
  EXPECT_GT(frame, 0.6 * kSoftwareFrameTargetMs);
}

TEST(QualityControl, ComesToRest) {
  QualityControl quality(30.0);
  run(quality, 5.0, 60.0, 600, 1);
  const Range range = run(quality, 5.0, 60.0, 400, 400);
  EXPECT_LT(range.high / range.low, 1.25f);
}

TEST(QualityControl, IgnoresASingleSlowFrame) {
  QualityControl quality;
  run(quality, 5.0, 10.0, 100, 1);
  quality.frameDone(900.0);
  run(quality, 5.0, 10.0, 20, 1);
  EXPECT_EQ(quality.detail(), 1.0f);
}

TEST(QualityControl, RecoversWhenTheLoadIsGone) {
  QualityControl quality;
  run(quality, 10.0, 200.0, 300, 1);
  ASSERT_LT(quality.detail(), 0.3f);
  run(quality, 2.0, 8.0, 3000, 1);
  EXPECT_EQ(quality.detail(), 1.0f);
}

TEST(QualityControl, NeverGoesBelowItsLeastDetail) {
  QualityControl quality;
  run(quality, 500.0, 100.0, 500, 1);
  EXPECT_EQ(quality.detail(), QualityControl::kLeastDetail);
}

TEST(QualityControl, IgnoresTimesThatAreNone) {
  QualityControl quality;
  for (int i = 0; i < 50; ++i) {
    quality.frameDone(std::numeric_limits<double>::quiet_NaN());
    quality.frameDone(-1.0);
    quality.frameDone(0.0);
  }
  EXPECT_EQ(quality.detail(), 1.0f);
}

}  // namespace
}  // namespace windloom
