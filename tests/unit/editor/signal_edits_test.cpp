#include "editor/core/signal_edits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/model/evaluate.hpp"
#include "engine/model/validate.hpp"

namespace windloom::editor {
namespace {

using Keys = std::vector<std::size_t>;

Project projectWith(std::optional<Signal> signal) {
  auto graph = std::make_shared<WindGraph>();
  graph->points.resize(2);
  graph->points[0].id = 1;
  graph->points[1].id = 2;
  graph->points[1].position = {10, 0};
  Arrow arrow;
  arrow.id = 3;
  arrow.from = 1;
  arrow.to = 2;
  graph->arrows = {arrow};
  if (signal) {
    signal->root = 1;
    graph->signals = {*signal};
  }
  Project project;
  project.graph = graph;
  return project;
}

Project curveProject(bool loop, std::vector<SignalKey> keys) {
  Signal signal;
  signal.kind = SignalKind::Curve;
  signal.loop = loop;
  signal.period = 6;
  signal.keys = std::move(keys);
  return projectWith(signal);
}

/// Every edit must leave a valid project.
Signal after(const Project& project, const Edit& edit) {
  EXPECT_FALSE(edit.steps.empty());
  const Result<Project> result = applyEdit(project, edit);
  EXPECT_TRUE(result.ok()) << (result ? "" : result.error().text());
  return result ? signalOf(*result, 1) : Signal{};
}

double greatestDifference(const Signal& a, const Signal& b, double from, double to) {
  double greatest = 0;
  for (double t = from; t < to; t += 0.003)
    greatest = std::max(greatest, std::abs(double(signalAt(a, t) - signalAt(b, t))));
  return greatest;
}

}  // namespace

TEST(SignalEdits, ARootWithoutASignalGetsOneOnTheFirstEdit) {
  const Project project = projectWith(std::nullopt);
  EXPECT_EQ(signalOf(project, 1).kind, SignalKind::Constant);
  const Signal curve = after(project, convertToCurveEdit(project, 1));
  EXPECT_EQ(curve.root, 1u);
  EXPECT_EQ(curve.kind, SignalKind::Curve);
  EXPECT_LT(greatestDifference(curve, Signal{}, 0, 20), 1e-6);
}

TEST(SignalEdits, AddedKeysLieInOrderWithinRangeAndTakeTheEasing) {
  const Project project = curveProject(true, {{0, 1, Easing::Smooth}, {4, 0}});
  const AddKeyResult added = addKeyEdit(project, 1, 14.5, 9);
  const Signal signal = after(project, added.edit);
  ASSERT_EQ(signal.keys.size(), 3u);
  EXPECT_EQ(added.index, 1u);
  EXPECT_EQ(signal.keys[1], (SignalKey{2.5f, 4, Easing::Smooth})) << "the third round is the first";
  const AddKeyResult moved = addKeyEdit(project, 1, 4.001, 2);
  EXPECT_EQ(after(project, moved.edit).keys.size(), 2u) << "a key there is moved";
  EXPECT_TRUE(addKeyEdit(projectWith(std::nullopt), 1, 1, 1).edit.steps.empty()) << "not a curve";
}

TEST(SignalEdits, MovedKeysStayBetweenTheirNeighbours) {
  const Project project = curveProject(false, {{0, 1}, {1, 1}, {2, 3}, {5, 0}});
  Signal signal = after(project, moveKeysEdit(project, 1, Keys{1, 2}, 100, 0.5));
  EXPECT_NEAR(signal.keys[2].time, 5 - kLeastKeyGapS, 1e-4f);
  EXPECT_NEAR(signal.keys[1].time, 4 - kLeastKeyGapS, 1e-4f) << "they move together";
  EXPECT_EQ(signal.keys[1].value, 1.5f);
  signal = after(project, moveKeysEdit(project, 1, Keys{1, 2}, -100, 100));
  EXPECT_NEAR(signal.keys[1].time, kLeastKeyGapS, 1e-6f);
  EXPECT_EQ(signal.keys[2].value, 4.0f);
  EXPECT_EQ(signal.keys[1].value, 2.0f) << "their shape stays";
  EXPECT_TRUE(moveKeysEdit(project, 1, Keys{}, 1, 1).steps.empty());
  EXPECT_TRUE(moveKeysEdit(project, 1, Keys{17}, 1, 1).steps.empty());
}

TEST(SignalEdits, TheSeamOfALoopKeepsOneValue) {
  const Project project = curveProject(true, {{0, 1}, {3, 2}, {6, 1}});
  EXPECT_EQ(after(project, moveKeysEdit(project, 1, Keys{0}, 0, 2)).keys.back().value, 3.0f);
  EXPECT_EQ(after(project, moveKeysEdit(project, 1, Keys{2}, 0, -1)).keys.front().value, 0.0f);
  EXPECT_EQ(after(project, moveKeysEdit(project, 1, Keys{0, 2}, 0, 1)).keys.front().value, 2.0f);
  const auto placed = placeKeyEdit(project, 1, 2, 6, 3);
  ASSERT_TRUE(placed.ok());
  EXPECT_EQ(after(project, *placed).keys.front().value, 3.0f);
}

TEST(SignalEdits, TypedPlacesAreRefusedWithWhatWasExpected) {
  const Project project = curveProject(true, {{0, 1}, {3, 2}, {5, 1}});
  EXPECT_TRUE(placeKeyEdit(project, 1, 1, 4.5, 0.25).ok());
  const auto late = placeKeyEdit(project, 1, 1, 5.5, 1);
  ASSERT_FALSE(late.ok());
  EXPECT_NE(late.error().text().find("expected a time from 0.01 to 4.99 s"), std::string::npos) << late.error().text();
  const auto high = placeKeyEdit(project, 1, 1, 3, 4.1);
  ASSERT_FALSE(high.ok());
  EXPECT_NE(high.error().text().find("expected a factor from 0 to 4"), std::string::npos);
  EXPECT_FALSE(placeKeyEdit(project, 1, 9, 3, 1).ok());
  EXPECT_FALSE(placeKeyEdit(project, 1, 1, std::nan(""), 1).ok());
}

TEST(SignalEdits, KeysAreErasedAndEased) {
  const Project project = curveProject(true, {{0, 1}, {3, 2}, {5, 1}});
  EXPECT_EQ(after(project, eraseKeysEdit(project, 1, Keys{0, 2})).keys, (std::vector<SignalKey>{{3, 2}}));
  EXPECT_EQ(after(project, easeKeysEdit(project, 1, Keys{1}, Easing::Hold)).keys[1].easing, Easing::Hold);
  EXPECT_TRUE(easeKeysEdit(project, 1, Keys{1}, Easing::Linear).steps.empty()) << "nothing to do";
  EXPECT_TRUE(eraseKeysEdit(project, 1, Keys{}).steps.empty());
}

TEST(SignalEdits, APlainPulseBecomesFourKeysThatPlayTheSame) {
  Signal pulse;
  pulse.kind = SignalKind::Pulse;
  pulse.delay = 1.5f;
  const Project project = projectWith(pulse);
  const Signal curve = after(project, convertToCurveEdit(project, 1));
  EXPECT_EQ(curve.keys.size(), 4u);
  EXPECT_LT(greatestDifference(curve, pulse, 0, 40), 0.01) << "the first hundredth of a second is its onset";
  EXPECT_LT(greatestDifference(curve, pulse, 7.5, 40), 1e-5);
}

TEST(SignalEdits, OverlappingPulsesAndGustsBecomeValidLoops) {
  Signal overlapping;
  overlapping.kind = SignalKind::Pulse;
  overlapping.period = 2;
  overlapping.on = 1.5f;
  overlapping.release = 3;
  Project project = projectWith(overlapping);
  EXPECT_LT(greatestDifference(after(project, convertToCurveEdit(project, 1)), overlapping, 20, 40), 0.05);
  Signal gusts;
  gusts.kind = SignalKind::Gusts;
  for (const float rate : {0.01f, 0.5f, 20.0f}) {
    gusts.rate = rate;
    project = projectWith(gusts);
    const Signal curve = after(project, convertToCurveEdit(project, 1));
    EXPECT_GE(curve.keys.size(), 8u);
    float low = 1, high = 0;
    for (const SignalKey& key : curve.keys) {
      low = std::min(low, key.value);
      high = std::max(high, key.value);
    }
    EXPECT_GE(low, 0.4f - 1e-3f);
    EXPECT_GT(high - low, 0.2f) << rate;
  }
}

TEST(SignalEdits, HandlesLieOnTheCourseAndComeBackWhereTheyWerePut) {
  Signal pulse;
  pulse.kind = SignalKind::Pulse;
  pulse.delay = 0.5f;
  Signal gusts = pulse, constant = pulse, curve = pulse;
  gusts.kind = SignalKind::Gusts;
  constant.kind = SignalKind::Constant;
  curve.kind = SignalKind::Curve;
  curve.keys = {{0, 1}, {2, 0}};
  for (const Signal& signal : {pulse, gusts, constant, curve}) {
    for (const double around : {0.0, 33.0}) {
      for (const HandlePlace& place : handlesOf(signal, around)) {
        const Signal same = withHandleAt(signal, place.handle, around, place.time, place.factor);
        for (const HandlePlace& again : handlesOf(same, around)) {
          if (again.handle != place.handle) continue;
          EXPECT_NEAR(again.time, place.time, 1e-4) << handleText(signal, place.handle);
        }
        EXPECT_FALSE(handleText(signal, place.handle).empty());
        for (const double time : {-1e9, 0.0, 50.0, 1e9}) {  // anywhere: still legal
          const Signal wild = withHandleAt(signal, place.handle, around, time, time);
          EXPECT_TRUE(validate(projectWith(wild)).empty()) << handleText(wild, place.handle);
        }
      }
    }
  }
  const Signal longer = withHandleAt(pulse, SignalHandle::Period, 20, 26.5, 0);
  EXPECT_NEAR(longer.period, 8, 1e-4f) << "the round around 20 s begins at 18.5 s";
  EXPECT_NEAR(withHandleAt(gusts, SignalHandle::Depth, 0, 0, 0.25).depth, 0.75f, 1e-6f);
}

}  // namespace windloom::editor
