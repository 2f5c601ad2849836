#include "engine/grass/touch_clock.hpp"

#include <gtest/gtest.h>

namespace windloom {
namespace {

constexpr double kStep = 1.0 / 60;

void expectJump(const TouchSteps& steps, double time) {
  EXPECT_TRUE(steps.fromRest);
  EXPECT_DOUBLE_EQ(steps.start, time - kTouchMemoryS);
  EXPECT_NEAR(steps.count * double(steps.seconds), kTouchMemoryS, 1e-5);
}

TEST(TouchClock, TheFirstPictureIsRunUpTo) {
  TouchClock clock;
  expectJump(clock.advance(0.0, kStep), 0.0);
}

TEST(TouchClock, GoesOnByWholeStepsWhateverTheFrameRate) {
  for (const int framesPerSecond : {10, 24, 30, 60, 144}) {
    TouchClock clock;
    clock.advance(1.0, kStep);
    double done = 1.0;
    for (int frame = 1; frame <= framesPerSecond; ++frame) {
      const TouchSteps steps = clock.advance(1.0 + double(frame) / framesPerSecond, kStep);
      EXPECT_FALSE(steps.fromRest);
      EXPECT_NEAR(steps.start, done, 1e-6);
      EXPECT_GE(steps.count, 1);
      EXPECT_LT(steps.seconds, 1.5 * kStep);
      done += steps.count * double(steps.seconds);
    }
    EXPECT_NEAR(done, 2.0, 1e-5);
  }
}

TEST(TouchClock, StandsWhereTimeStands) {
  TouchClock clock;
  clock.advance(3.0, kStep);
  const TouchSteps steps = clock.advance(3.0, kStep);
  EXPECT_FALSE(steps.fromRest);
  EXPECT_EQ(steps.count, 0);
}

TEST(TouchClock, BackAndFarAheadAreJumps) {
  TouchClock clock;
  clock.advance(10.0, kStep);
  expectJump(clock.advance(9.99, kStep), 9.99);
  expectJump(clock.advance(9.99 + 1.01 * kLongestTouchGapS, kStep), 9.99 + 1.01 * kLongestTouchGapS);
  clock.forget();
  expectJump(clock.advance(10.5, kStep), 10.5);
}

TEST(TouchClock, AQuickRunUpIsMadeGoodWhereThereIsTime) {
  TouchClock clock;
  const TouchSteps quick = clock.advance(5.0, kStep, RunUp::Quick);
  EXPECT_TRUE(quick.fromRest);
  EXPECT_GT(quick.count, 0);
  EXPECT_LT(quick.count, kTouchMemoryS / kStep / 4);
  EXPECT_NEAR(quick.start + quick.count * double(quick.seconds), 5.0, 1e-5);
  EXPECT_FALSE(clock.advance(5.02, kStep, RunUp::Quick).fromRest) << "playing on";
  expectJump(clock.advance(5.02, kStep, RunUp::Full), 5.02);
  EXPECT_EQ(clock.advance(5.02, kStep, RunUp::Full).count, 0);
  EXPECT_FALSE(clock.advance(5.02, kStep, RunUp::Quick).fromRest) << "what is full stays";
}

}  // namespace
}  // namespace windloom
