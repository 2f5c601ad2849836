#include "engine/bake/recorder.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace windloom {

TEST(RecordPlan, TakesTheFirstStepAtOrAfterAFramesTime) {
  const RecordPlan plan{1.0, 30.0, 10, 0};
  EXPECT_EQ(stepOfFrame(plan, 0, 0.1), 10);
  EXPECT_EQ(stepOfFrame(plan, 1, 0.1), 11);  // 1.0333 s
  EXPECT_EQ(stepOfFrame(plan, 3, 0.1), 11);  // 1.1 s, exactly
  EXPECT_EQ(stepOfFrame(plan, 4, 0.1), 12);
}

TEST(RecordPlan, ATimeStepRoundedToAFloatMovesNoFrame) {
  for (const float timeStep :
       {1.0f / 60.0f, 1.0f / 50.0f, 0.016666667f, std::nextafter(1.0f / 60.0f, 0.0f), 1.0f / 90.0f}) {
    const double rate = std::round(1.0 / static_cast<double>(timeStep));
    const RecordPlan plan{2.0, rate / 2.0, 1, 0};
    for (const int n : {0, 1, 2, 599, 1000, 50000}) {
      EXPECT_EQ(stepOfFrame(plan, n, static_cast<double>(timeStep)), static_cast<long>(2 * rate) + 2 * n)
          << timeStep << " " << n;
    }
  }
}

TEST(RecordPlan, FramesFasterThanStepsRepeatAStep) {
  const RecordPlan plan{0.0, 100.0, 10, 0};
  EXPECT_EQ(stepOfFrame(plan, 0, 0.02), 0);
  EXPECT_EQ(stepOfFrame(plan, 1, 0.02), 1);
  EXPECT_EQ(stepOfFrame(plan, 2, 0.02), 1);
  EXPECT_EQ(stepOfFrame(plan, 3, 0.02), 2);
}

TEST(RecordPlan, BlendsAQuarterOfALoop) {
  EXPECT_EQ(crossfadeFor(1), 0);
  EXPECT_EQ(crossfadeFor(2), 1);
  EXPECT_EQ(crossfadeFor(60), 15);
  const RecordPlan plan{0, 30, 8, 4};
  EXPECT_EQ(seamWeight(plan, 0), 0.0f);
  EXPECT_EQ(seamWeight(plan, 1), 0.25f);
  EXPECT_EQ(seamWeight(plan, 4), 1.0f);
  EXPECT_EQ(seamWeight(plan, 7), 1.0f);
}

}  // namespace windloom
