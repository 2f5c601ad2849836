#include <gtest/gtest.h>

#include <cmath>

#include "engine/model/evaluate.hpp"

namespace windloom {
namespace {

/// Greatest change of the factor over 1 ms, which bounds a jump.
float greatestStep(const Signal& signal, double until) {
  float greatest = 0;
  float last = signalAt(signal, 0);
  for (double t = 0.001; t < until; t += 0.001) {
    const float now = signalAt(signal, t);
    greatest = std::max(greatest, std::abs(now - last));
    last = now;
  }
  return greatest;
}

Signal signalOf(SignalKind kind) {
  Signal signal;
  signal.root = 1;
  signal.kind = kind;
  return signal;
}

}  // namespace

TEST(Signal, NothingBlowsBeforeTheDelay) {
  Signal signal;
  signal.delay = 2;
  for (SignalKind kind : {SignalKind::Constant, SignalKind::Pulse, SignalKind::Gusts, SignalKind::Curve}) {
    signal.kind = kind;
    EXPECT_EQ(signalAt(signal, 1.99), 0);
    EXPECT_GT(signalAt(signal, 3), 0);
  }
}

TEST(Signal, PulseRisesHoldsFallsAndRepeats) {
  Signal pulse;
  pulse.kind = SignalKind::Pulse;
  pulse.period = 6;
  pulse.on = 2.5f;
  pulse.attack = 0.4f;
  pulse.release = 1;
  EXPECT_FLOAT_EQ(signalAt(pulse, 0.4), 1);
  EXPECT_FLOAT_EQ(signalAt(pulse, 2.4), 1);
  EXPECT_NEAR(signalAt(pulse, 3.0), 0.5f, 1e-5f);
  EXPECT_EQ(signalAt(pulse, 4.0), 0);
  for (double t = 0; t < 6; t += 0.1) EXPECT_NEAR(signalAt(pulse, t), signalAt(pulse, t + 12), 1e-5f) << t;
}

TEST(Signal, EveryKindIsContinuous) {
  Signal signal;
  signal.keys = {{0, 0.2f}, {1, 2}, {2.5f, 0}, {4, 1}};
  for (SignalKind kind : {SignalKind::Constant, SignalKind::Pulse, SignalKind::Gusts, SignalKind::Curve}) {
    signal.kind = kind;
    EXPECT_LT(greatestStep(signal, 20), 0.02f) << static_cast<int>(kind);
  }
  signal.kind = SignalKind::Pulse;  // pulses that overlap, and one that never comes to full strength
  signal.release = 9;
  EXPECT_LT(greatestStep(signal, 20), 0.02f);
  signal.attack = 3;
  signal.on = 1;
  EXPECT_LT(greatestStep(signal, 20), 0.02f);
}

TEST(Signal, GustsStayBetweenDepthAndFullAndFollowTheSeed) {
  Signal gusts;
  gusts.kind = SignalKind::Gusts;
  gusts.depth = 0.6f;
  Signal other = gusts;
  other.seed = 2;
  float low = 1;
  float high = 0;
  bool differs = false;
  for (double t = 1; t < 200; t += 0.05) {
    const float value = signalAt(gusts, t);
    low = std::min(low, value);
    high = std::max(high, value);
    differs |= std::abs(value - signalAt(other, t)) > 0.1f;
    EXPECT_EQ(value, signalAt(gusts, t));
  }
  EXPECT_GE(low, 0.4f - 1e-5f);
  EXPECT_LE(high, 1.0f);
  EXPECT_GT(high - low, 0.3f);
  EXPECT_TRUE(differs);
}

TEST(Signal, CurveGoesStraightBetweenKeysAndLoops) {
  Signal curve;
  curve.kind = SignalKind::Curve;
  curve.attack = 0.01f;
  curve.period = 4;
  curve.keys = {{1, 0}, {2, 2}, {3, 0}};
  EXPECT_NEAR(signalAt(curve, 1.5), 1, 1e-5f);
  EXPECT_NEAR(signalAt(curve, 2), 2, 1e-5f);
  EXPECT_NEAR(signalAt(curve, 4 + 2.25), 1.5f, 1e-5f);
  curve.loop = false;
  EXPECT_NEAR(signalAt(curve, 50), 0, 1e-5f);
}

TEST(Signal, ConstantStaysFullAfterTheAttack) {
  Signal signal = signalOf(SignalKind::Constant);
  signal.attack = 0.4f;
  EXPECT_FLOAT_EQ(signalAt(signal, 0.2), 0.5f);
  EXPECT_EQ(signalAt(signal, 0.5), 1.0f);
  EXPECT_EQ(signalAt(signal, 1e6), 1.0f);
}

TEST(Signal, OverlappingPulsesAndLoopedCurvesAreContinuous) {
  Signal shortPulse = signalOf(SignalKind::Pulse);  // released long before the attack is over
  shortPulse.on = 0.3f;
  shortPulse.attack = 1;
  shortPulse.release = 2;
  Signal overlapping = signalOf(SignalKind::Pulse);  // the next onset comes during the release
  overlapping.period = 1;
  overlapping.on = 0.6f;
  overlapping.release = 3;
  Signal longerThanPeriod = signalOf(SignalKind::Pulse);
  longerThanPeriod.period = 1;
  longerThanPeriod.on = 2.4f;
  longerThanPeriod.attack = 2;
  Signal curve = signalOf(SignalKind::Curve);
  curve.period = 5;
  curve.keys = {{1, 0.2f}, {2, 1.5f}, {3.5f, 0.8f}};
  for (const Signal& signal : {shortPulse, overlapping, longerThanPeriod, curve, signalOf(SignalKind::Gusts)}) {
    EXPECT_LT(greatestStep(signal, 20), 0.01f) << static_cast<int>(signal.kind);
  }
}

TEST(Signal, AShortPulseFallsFromWhereItGotTo) {
  Signal signal = signalOf(SignalKind::Pulse);
  signal.attack = 1;
  signal.on = 0.5f;  // level 0.5, which smoothing leaves at 0.5
  signal.release = 2;
  EXPECT_FLOAT_EQ(signalAt(signal, 0.5), 0.5f);
  EXPECT_GT(signalAt(signal, 1.4), 0.0f);
  EXPECT_EQ(signalAt(signal, 1.51), 0.0f);
}

TEST(Signal, ALoopedCurveJoinsItsLastKeyToItsFirst) {
  Signal signal = signalOf(SignalKind::Curve);
  signal.attack = 0.01f;
  signal.period = 4;
  signal.keys = {{1, 0}, {3, 2}};
  EXPECT_FLOAT_EQ(signalAt(signal, 4), 1.0f);
  EXPECT_FLOAT_EQ(signalAt(signal, 6), 1.0f);
  EXPECT_FLOAT_EQ(signalAt(signal, 4 * 7 + 3), 2.0f);
}

TEST(Signal, ACurveWithoutKeysIsFull) {
  EXPECT_EQ(signalAt(signalOf(SignalKind::Curve), 5), 1.0f);
}

}  // namespace windloom
