#include "engine/session/quality_control.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

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

TEST(QualityControl, BeginsWithLittleOnASoftwareRenderer) {
  QualityControl quality(kSoftwareTarget);
  EXPECT_EQ(quality.detail(), 0.2f);
  run(quality, 5.0, 20.0, 4000, 1);
  EXPECT_EQ(quality.detail(), 1.0f) << "and finds that there is room for more";
}

TEST(QualityControl, ReachesItsTargetOnASlowMachine) {
  QualityControl quality({.frameMs = 60});
  run(quality, 20.0, 400.0, 600, 1);
  const double frame = 20.0 + 400.0 * static_cast<double>(quality.detail());
  EXPECT_LT(frame, 1.1 * 60.0);
  EXPECT_GT(frame, 0.6 * 60.0);
}

TEST(QualityControl, ComesToRest) {
  QualityControl quality({.frameMs = 30});
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

/// A machine that isn't alone: each frame varies, some take three times as long, and over seconds everything gets
/// slower and faster again. At times it steps the wind twice.
struct NoisyMachine {
  double fixedMs, grassMs, exponent;
  std::mt19937 random;
  double seconds = 0.0;
  int changes = 0;
  std::vector<double> times = {};

  void run(QualityControl& quality, double until) {
    std::normal_distribution<double> jitter(0.0, 0.15);
    std::uniform_real_distribution<double> dice(0.0, 1.0);
    changes = 0;
    times.clear();
    for (bool moving = false; seconds < until;) {
      const float before = quality.detail();
      double ms = fixedMs + grassMs * std::pow(static_cast<double>(before), exponent);
      ms *= std::max(0.5, 1.0 + jitter(random)) * (1.0 + 0.06 * std::sin(seconds));
      if (dice(random) < 0.02) ms *= 3.0;
      if (dice(random) < 0.2) ms += 0.1 * quality.targetMs();
      quality.frameDone(ms);
      seconds += ms * 1e-3;
      times.push_back(ms);
      const bool moves = quality.detail() != before;
      if (moves && !moving) ++changes;
      moving = moves;
    }
  }
  double medianMs() {
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
  }
};

TEST(QualityControl, NeverPumpsOnANoisyMachine) {
  for (const double target : {30.0, 60.0}) {
    for (const double fixedPart : {0.1, 0.3, 0.6}) {
      for (const double grassPart : {0.5, 1.0, 2.0, 8.0}) {
        for (const double exponent : {0.5, 0.8, 1.0}) {
          for (unsigned seed = 1; seed <= 5; ++seed) {
            SCOPED_TRACE(::testing::Message() << target << " ms, fixed " << fixedPart << ", grass " << grassPart
                                              << ", exponent " << exponent << ", seed " << seed);
            QualityControl quality({.frameMs = target});
            NoisyMachine machine{fixedPart * target, grassPart * target, exponent, std::mt19937(seed)};
            machine.run(quality, 10.0);
            EXPECT_LE(machine.changes, 6) << "while it settles";
            machine.run(quality, 20.0);
            EXPECT_LE(machine.changes, 1) << "once it has settled";
            const float detail = quality.detail();
            if (detail > QualityControl::kLeastDetail) {
              EXPECT_LT(machine.medianMs(), 1.1 * target);
            }
            if (detail < 1.0f) {
              EXPECT_GT(machine.medianMs(), 0.6 * target);
            }
            machine.run(quality, 60.0);
            EXPECT_LE(machine.changes, 3) << "in the next 40 s";
          }
        }
      }
    }
  }
}

TEST(QualityControl, NoFrameJumpsUnlessFramesAreFarTooSlow) {
  QualityControl quality({.frameMs = 30});
  for (const double grassMs : {36.0, 20.0}) {  // a little too slow; then with room to spare
    for (int i = 0; i < 2000; ++i) {
      const float before = quality.detail();
      quality.frameDone(2.0 + grassMs * static_cast<double>(before));
      EXPECT_NEAR(quality.detail() / before, 1.0f, 0.032f);
    }
  }
  EXPECT_EQ(quality.detail(), 1.0f);
}

TEST(QualityControl, HelpsSoonWhereFramesAreFarTooSlow) {
  QualityControl quality({.frameMs = 30});
  double seconds = 0.0;
  while (seconds < 4.0) {
    const double ms = 5.0 + 200.0 * static_cast<double>(quality.detail());
    quality.frameDone(ms);
    seconds += ms * 1e-3;
  }
  EXPECT_LT(5.0 + 200.0 * static_cast<double>(quality.detail()), 1.2 * 30.0);
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
