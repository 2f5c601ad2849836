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

TEST(Signal, ASmoothCurveHasNoKinkAndStaysBetweenItsKeys) {
  Signal curve = signalOf(SignalKind::Curve);
  curve.attack = 0.01f;
  curve.period = 6;
  curve.keys = {{0.5f, 0, Easing::Smooth}, {1, 0.1f, Easing::Smooth}, {2, 3.5f, Easing::Smooth},
                {2.2f, 4, Easing::Smooth}, {3, 0, Easing::Smooth},    {5, 0, Easing::Smooth}};
  double lastSlope = 0, greatestBend = 0;
  for (double t = 6; t < 18; t += 0.001) {
    const double now = double(signalAt(curve, t)), slope = (double(signalAt(curve, t + 0.001)) - now) / 0.001;
    ASSERT_GE(now, 0) << t;
    ASSERT_LE(now, 4) << t;
    if (t > 6) greatestBend = std::max(greatestBend, std::abs(slope - lastSlope));
    lastSlope = slope;
  }
  EXPECT_LT(greatestBend, 0.5) << "the slope jumps";
  for (std::size_t k = 0; k + 1 < curve.keys.size(); ++k) {  // monotone between neighbours
    const SignalKey &a = curve.keys[k], &b = curve.keys[k + 1];
    float last = a.value;
    for (int i = 0; i <= 100; ++i) {
      const float now = signalAt(curve, 6 + std::lerp(double(a.time), double(b.time), i / 100.0));
      EXPECT_GE((now - last) * (b.value - a.value), -1e-5f) << k << " " << i;
      last = now;
    }
    EXPECT_NEAR(signalAt(curve, 6 + double(b.time)), b.value, 1e-5f);
  }
}

TEST(Signal, ALoopedSmoothCurveHasNoKinkAtItsSeam) {
  Signal curve = signalOf(SignalKind::Curve);
  curve.period = 4;
  curve.keys = {{0, 1, Easing::Smooth}, {1, 2, Easing::Smooth}, {3, 0, Easing::Smooth}, {4, 1, Easing::Smooth}};
  const auto slope = [&](double t) { return double(signalAt(curve, t + 1e-3) - signalAt(curve, t)) / 1e-3; };
  EXPECT_NEAR(slope(8 - 2e-3), slope(8 + 1e-3), 0.05);
  EXPECT_GT(slope(8), 0.5) << "rising from 0 through 1 to 2";
}

TEST(Signal, AHeldKeyJumpsAtTheNextOne) {
  Signal curve = signalOf(SignalKind::Curve);
  curve.attack = 0.01f;
  curve.loop = false;
  curve.keys = {{1, 0.5f, Easing::Hold}, {2, 2}, {3, 1, Easing::Smooth}, {4, 2}};
  EXPECT_FLOAT_EQ(signalAt(curve, 1.999), 0.5f);
  EXPECT_FLOAT_EQ(signalAt(curve, 2), 2.0f);
  EXPECT_FLOAT_EQ(signalAt(curve, 2.5), 1.5f) << "straight after it";
  EXPECT_NEAR(signalAt(curve, 3.5), 1.5f, 0.2f);
  EXPECT_FLOAT_EQ(signalAt(curve, 60), 2.0f);
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
