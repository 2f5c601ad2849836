#include "editor/core/probe_traces.hpp"

#include <gtest/gtest.h>

namespace windloom::editor {
namespace {

Probe probeAt(Id id, glm::vec2 place) {
  Probe probe;
  probe.id = id;
  probe.position = place;
  return probe;
}

}  // namespace

class Traces : public ::testing::Test {
 protected:
  void SetUp() override {
    traces.follow(probes);
    for (int i = 0; i <= 100; ++i) traces.add(i * 0.1, {1, 2}, {float(i), 0});
  }
  std::vector<Probe> probes{probeAt(7, {1, 2}), probeAt(8, {5, 5})};
  ProbeTraces traces;
};

TEST_F(Traces, BelongToTheProbeAtTheirPlace) {
  EXPECT_EQ(traces.samples(7).size(), 101u);
  EXPECT_TRUE(traces.samples(8).empty());
  EXPECT_TRUE(traces.samples(9).empty());
  ASSERT_TRUE(traces.at(7, 5.05));
  EXPECT_NEAR(traces.at(7, 5.05)->x, 50.5f, 1e-3f);
  EXPECT_FALSE(traces.at(7, 11));
  EXPECT_FALSE(traces.at(7, -1));
}

TEST_F(Traces, GoingBackCutsOffWhatComesAfter) {
  traces.cutAfter(4.0);
  EXPECT_NEAR(traces.samples(7).back().time, 4.0, 1e-9);
  traces.add(2.0, {1, 2}, {99, 0});
  EXPECT_NEAR(traces.samples(7).back().time, 2.0, 1e-9);
  EXPECT_EQ(traces.samples(7).back().wind.x, 99);
}

TEST_F(Traces, HaveNoValueInAGap) {
  traces.add(13, {1, 2}, {3, 0});
  EXPECT_FALSE(traces.at(7, 12));
  EXPECT_EQ(traces.at(7, 13)->x, 3);
}

TEST_F(Traces, StartAgainWhereTheProbeMoved) {
  probes[0].position = {2, 2};
  traces.follow(probes);
  EXPECT_TRUE(traces.samples(7).empty());
  probes.pop_back();
  traces.follow(probes);
  traces.add(1, {5, 5}, {1, 1});
  EXPECT_TRUE(traces.samples(8).empty()) << "its probe is gone";
}

TEST_F(Traces, KeepTheNewestSamplesOnly) {
  for (int i = 0; i < 10'000; ++i) traces.add(100 + i * 0.01, {5, 5}, {0, 0});
  EXPECT_EQ(traces.samples(8).size(), ProbeTraces::kMostSamples);
  EXPECT_NEAR(traces.samples(8).back().time, 199.99, 1e-6);
}

TEST(Heading, TurnsFromXTowardsZ) {
  EXPECT_FLOAT_EQ(*headingDeg({1, 0}), 0);
  EXPECT_FLOAT_EQ(*headingDeg({0, 2}), 90);
  EXPECT_FLOAT_EQ(*headingDeg({0, -2}), 270);
  EXPECT_FALSE(headingDeg({0, 0}));
}

}  // namespace windloom::editor
