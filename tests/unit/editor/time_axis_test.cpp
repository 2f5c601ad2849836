#include "editor/core/time_axis.hpp"

#include <gtest/gtest.h>

namespace windloom::editor {

TEST(TimeAxis, ZoomKeepsTheTimeUnderThePointer) {
  const TimeAxis axis{10, 20};
  const TimeAxis near = zoomed(axis, 0.5, 15);
  EXPECT_DOUBLE_EQ(near.seconds, 10);
  EXPECT_DOUBLE_EQ(near.part(15), axis.part(15));
  EXPECT_DOUBLE_EQ(zoomed(axis, 1e-9, 15).seconds, 0.2);
  EXPECT_DOUBLE_EQ(zoomed(axis, 1e9, 15).seconds, 7200);
}

TEST(TimeAxis, HardlyShowsTimeBeforeTheStart) {
  EXPECT_DOUBLE_EQ(panned({10, 20}, -100).from, -1);
  EXPECT_DOUBLE_EQ(panned({10, 20}, 5).from, 15);
  const TimeAxis all = framed(2, 12);
  EXPECT_LT(all.from, 2);
  EXPECT_GT(all.to(), 12);
  EXPECT_GT(framed(3, 3).seconds, 0);
}

TEST(TimeAxis, FollowsTimeOnlyWhereItLeaves) {
  const TimeAxis axis{10, 20};
  EXPECT_DOUBLE_EQ(following(axis, 29).from, 10);
  EXPECT_DOUBLE_EQ(following(axis, 31).from, 29);
  EXPECT_LE(following(axis, 1).from, 1);
}

TEST(TimeAxis, TicksAreRoundAndWithinTheStretch) {
  EXPECT_DOUBLE_EQ(tickStep(0.03), 0.05);
  EXPECT_DOUBLE_EQ(tickStep(1), 1);
  EXPECT_DOUBLE_EQ(tickStep(6), 10);
  const auto ticks = ticksBetween(-0.1, 1.0, 0.2);
  ASSERT_EQ(ticks.size(), 6u);
  EXPECT_EQ(ticks[0].text, "0.0");
  EXPECT_EQ(ticks[5].text, "1.0");
  EXPECT_EQ(ticksBetween(9, 31, 10).front().text, "10");
}

TEST(SteadyTop, GrowsAtOnceAndShrinksLater) {
  SteadyTop top(1);
  EXPECT_DOUBLE_EQ(top.update(0.2, 0), 1);
  const double high = top.update(9, 1);
  EXPECT_GE(high, 9);
  EXPECT_LE(high, 12);
  EXPECT_EQ(top.update(8, 1.1), high);
  EXPECT_EQ(top.update(1, 2), high) << "a lull";
  EXPECT_EQ(top.update(1, 4.5), high);
  EXPECT_LT(top.update(1, 6), 3);
}

}  // namespace windloom::editor
