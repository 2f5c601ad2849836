#include <gtest/gtest.h>

#include "engine/model/evaluate.hpp"
#include "tests/unit/model/model_fixture.hpp"

namespace windloom {
namespace {

/// Always on after a short onset, so that a factor tells whether the signal has arrived.
Signal quickConstant(Id root) {
  Signal signal;
  signal.root = root;
  signal.attack = 0.01f;
  return signal;
}

}  // namespace

TEST(WindGraph, RootsArePointsWithoutIncomingArrows) {
  WindGraph graph = smallTree();
  graph.points.push_back(pointAt(5, {50, 50}));  // alone: no root
  EXPECT_EQ(findRoots(graph), (std::vector<Id>{1}));
}

TEST(WindGraph, RingTakesItsLowestPointUnlessOneIsMarked) {
  WindGraph ring;
  ring.points = {pointAt(7, {0, 0}), pointAt(5, {10, 0}), pointAt(9, {0, 10})};
  ring.arrows = {arrowBetween(20, 7, 5), arrowBetween(21, 5, 9), arrowBetween(22, 9, 7)};
  EXPECT_EQ(findRoots(ring), (std::vector<Id>{5}));
  ring.points[2].root = true;
  EXPECT_EQ(findRoots(ring), (std::vector<Id>{9}));
}

TEST(GraphEvaluator, SignalTravelsFromTheRootToTheTips) {
  const GraphEvaluator evaluator(smallTree());
  const std::vector<Arrival>& arrivals = evaluator.arrivals();
  EXPECT_DOUBLE_EQ(arrivals[0].time, 0);
  EXPECT_DOUBLE_EQ(arrivals[1].time, 1);
  EXPECT_DOUBLE_EQ(arrivals[2].time, 2);
  EXPECT_DOUBLE_EQ(arrivals[3].time, 3);
  for (const Arrival& arrival : arrivals) EXPECT_EQ(arrival.root, 1u);
}

TEST(GraphEvaluator, ArrowsFireInSequence) {
  WindGraph graph = smallTree();
  graph.signals = {quickConstant(1)};
  const GraphEvaluator evaluator(graph);
  EXPECT_EQ(evaluator.forcesAt(0).size(), 0u);
  EXPECT_EQ(evaluator.forcesAt(0.5).size(), 1u);  // 1 -> 2 blows at once
  EXPECT_EQ(evaluator.forcesAt(1.5).size(), 3u);  // both branches leave point 2 when it is reached
  EXPECT_FLOAT_EQ(evaluator.factorAt(1, 0.99), 0);
  EXPECT_FLOAT_EQ(evaluator.factorAt(1, 1.1), 1);
}

TEST(GraphEvaluator, MergedPointIsReachedByTheFirstFlow) {
  WindGraph graph;  // two roots meet in 3; root 2 is nearer
  graph.points = {pointAt(1, {-30, 0}), pointAt(2, {10, 0}), pointAt(3, {0, 0}), pointAt(4, {0, 10})};
  graph.arrows = {arrowBetween(10, 1, 3), arrowBetween(11, 2, 3), arrowBetween(12, 3, 4)};
  const GraphEvaluator evaluator(graph);
  EXPECT_EQ(evaluator.arrivals()[2].root, 2u);
  EXPECT_DOUBLE_EQ(evaluator.arrivals()[2].time, 1);
  EXPECT_EQ(evaluator.arrivals()[3].root, 2u);
}

TEST(GraphEvaluator, EqualTimesGoToTheLowestArrow) {
  WindGraph graph;
  graph.points = {pointAt(1, {-10, 0}), pointAt(2, {10, 0}), pointAt(3, {0, 0})};
  graph.arrows = {arrowBetween(21, 1, 3), arrowBetween(20, 2, 3)};
  EXPECT_EQ(GraphEvaluator(graph).arrivals()[2].root, 2u);
}

TEST(GraphEvaluator, RingEndsByItself) {
  WindGraph ring;
  ring.points = {pointAt(1, {0, 0}), pointAt(2, {10, 0}), pointAt(3, {10, 10})};
  ring.arrows = {arrowBetween(20, 1, 2), arrowBetween(21, 2, 3), arrowBetween(22, 3, 1)};
  ring.signals = {quickConstant(1)};
  const GraphEvaluator evaluator(ring);
  EXPECT_DOUBLE_EQ(evaluator.arrivals()[0].time, 0);
  EXPECT_EQ(evaluator.forcesAt(5).size(), 3u);  // the closing arrow blows too
}

TEST(GraphEvaluator, MutedArrowPassesTheSignalOnButDoesNotBlow) {
  WindGraph graph = smallTree();
  graph.arrows[0].muted = true;
  graph.signals = {quickConstant(1)};
  const GraphEvaluator evaluator(graph);
  EXPECT_EQ(evaluator.forcesAt(0.5).size(), 0u);
  EXPECT_EQ(evaluator.forcesAt(1.5).size(), 2u);
}

TEST(GraphEvaluator, ForceCarriesPlaceDirectionAndFactor) {
  WindGraph graph = smallTree();
  graph.arrows[2].where = Where::End;
  graph.arrows[2].strength = 6;
  const std::vector<ArrowForce> forces = GraphEvaluator(graph).forcesAt(100);
  ASSERT_EQ(forces.size(), 3u);
  EXPECT_EQ(forces[0].from, glm::vec2(0, 0));
  EXPECT_EQ(forces[0].to, glm::vec2(10, 0));
  EXPECT_EQ(forces[2].from, forces[2].to);
  EXPECT_EQ(forces[2].direction, glm::vec2(0, 1));
  EXPECT_FLOAT_EQ(forces[2].strength, 6);
  EXPECT_FLOAT_EQ(forces[2].factor, 1);
}

TEST(WindGraph, LeavesOutRingsThatAnotherRingLeadsTo) {
  WindGraph graph;  // ring 5-6 leads to ring 1-2, whose ids are lower
  graph.points = {pointAt(1, {0, 0}), pointAt(2, {10, 0}), pointAt(5, {0, 20}), pointAt(6, {10, 20})};
  graph.arrows = {arrowBetween(11, 1, 2), arrowBetween(12, 2, 1), arrowBetween(13, 5, 6), arrowBetween(14, 6, 5),
                  arrowBetween(15, 6, 2)};
  EXPECT_EQ(findRoots(graph), std::vector<Id>{5});
}

TEST(GraphEvaluator, PointsWithoutArrowsAreNeverReached) {
  WindGraph graph = line();
  graph.points.push_back(pointAt(4, {90, 90}));
  EXPECT_EQ(GraphEvaluator(graph).arrivals().back().time, std::numeric_limits<double>::infinity());
}

TEST(GraphEvaluator, ArrowsOfAGraphThatIsNotValidYetAreLeftOut) {
  WindGraph graph = line();
  graph.arrows.push_back(arrowBetween(13, 2, 77));
  graph.arrows.push_back(arrowBetween(14, 2, 2));
  EXPECT_EQ(GraphEvaluator(graph).forcesAt(100).size(), 2u);
}

TEST(GraphEvaluator, FactorScalesStrengthAndSwirl) {
  WindGraph graph = line();
  graph.arrows[0].strength = 8;
  graph.arrows[0].swirl = -4;
  Signal curve = quickConstant(1);
  curve.kind = SignalKind::Curve;
  curve.loop = false;
  curve.keys = {{0, 0.5f}};
  graph.signals = {curve};
  const ArrowForce force = GraphEvaluator(graph).forcesAt(50).front();
  EXPECT_EQ(force.factor, 0.5f);
  EXPECT_EQ(force.strength, 4.0f);
  EXPECT_EQ(force.swirl, -2.0f);
}

TEST(AmbientVelocity, DirectionTurnsFromXTowardsZ) {
  AmbientWind ambient;
  ambient.speed = 4;
  ambient.direction = 90;
  const glm::vec2 velocity = ambientVelocity(ambient);
  EXPECT_NEAR(velocity.x, 0, 1e-6);
  EXPECT_FLOAT_EQ(velocity.y, 4);
}

}  // namespace windloom
