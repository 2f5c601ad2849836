#include "editor/core/brush_strokes.hpp"

#include "editor_bench.hpp"

namespace windloom::editor {
namespace {

/// Drags along with a tick of `seconds` before each of four moves.
void comb(Bench& b, glm::vec2 from, glm::vec2 to, double seconds) {
  b.press(from);
  for (int i = 1; i <= 4; ++i) {
    b.w.tick(seconds / 4, {});
    b.move(glm::mix(from, to, 0.25f * static_cast<float>(i)));
  }
  b.release(to);
}

TEST(Brush, StrokesPushAlongThePointerWithItsSpeed) {
  Bench b;
  b.key("B");
  comb(b, {-10, 0}, {10, 0}, 2.0);
  const auto forces = b.w.strokes.forces();
  ASSERT_EQ(forces.size(), 4u);
  for (const ArrowForce& force : forces) {
    EXPECT_NEAR(force.direction.x, 1.0f, 1e-5f);
    EXPECT_NEAR(force.strength, 10.0f, 0.1f);
    EXPECT_EQ(force.radius, b.w.toolSettings.brush.radiusM);
    EXPECT_EQ(force.factor, 1.0f);
  }
  EXPECT_NEAR(forces.front().from.x, -10.0f, 0.1f);
  EXPECT_NEAR(forces.back().to.x, 10.0f, 0.1f);
}

TEST(Brush, IsNoEdit) {
  Bench b;
  b.key("B");
  comb(b, {-10, 0}, {10, 0}, 1.0);
  EXPECT_EQ(b.steps(), 0u);
  EXPECT_FALSE(b.w.document.dirty());
  EXPECT_TRUE(b.graph().arrows.empty());
}

TEST(Brush, StrokesFadeWithTheWindsTimeAndGo) {
  BrushStrokes strokes;
  strokes.add({0, 0}, {1, 0}, 5, 2);
  strokes.age(0);
  EXPECT_EQ(strokes.forces().at(0).factor, 1.0f) << "while the wind stands they wait";
  float last = 1.0f;
  for (double t = 0.1; t < BrushStrokes::kLifeS - 0.01; t += 0.1) {
    strokes.age(0.1);
    const float factor = strokes.forces().at(0).factor;
    EXPECT_LE(factor, last);
    EXPECT_GT(factor, 0.0f);
    EXPECT_EQ(strokes.forces().at(0).strength, 5.0f) << "it lets go, it doesn't brake";
    last = factor;
  }
  strokes.age(0.2);
  EXPECT_TRUE(strokes.empty());
}

TEST(Brush, RefusesWhatHasNoLengthAndKeepsToItsLimits) {
  BrushStrokes strokes;
  strokes.add({1, 1}, {1, 1}, 5, 2);
  strokes.add({1, 1}, {2, 1}, 0, 2);
  strokes.add({1, 1}, {2, 1}, std::nanf(""), 2);
  strokes.add({1, 1}, {std::nanf(""), 1}, 5, 2);
  EXPECT_TRUE(strokes.empty());
  strokes.add({1, 1}, {2, 1}, 1e9f, 1e9f);
  EXPECT_EQ(strokes.forces().at(0).strength, kMaxBrushSpeedMps);
  EXPECT_EQ(strokes.forces().at(0).radius, kMaxBrushM);
  for (int i = 0; i < 1000; ++i) strokes.add({0, 0}, {1, 0}, 1, 1);
  EXPECT_EQ(strokes.size(), BrushStrokes::kMaxCount);
}

TEST(Brush, BracketsAndTheWheelChangeRadiusAndStrength) {
  Bench b;
  b.key("B");
  BrushSettings& brush = b.w.toolSettings.brush;
  const BrushSettings before = brush;
  b.key("]");
  EXPECT_GT(brush.radiusM, before.radiusM);
  b.key("[");
  EXPECT_NEAR(brush.radiusM, before.radiusM, 1e-4f);
  b.key("Shift+]");
  EXPECT_GT(brush.strength, before.strength);
  b.key("Shift+[");
  EXPECT_NEAR(brush.strength, before.strength, 1e-4f);
  b.press({0, 0});
  b.move({5, 0});
  b.w.wheel(2.0f, b.at({5, 0}));
  EXPECT_GT(brush.radiusM, before.radiusM);
  b.w.wheel(-1.0f, b.at({5, 0}, kShift));
  EXPECT_LT(brush.strength, before.strength);
  b.release({5, 0});
}

TEST(Brush, ShowsItsRing) {
  Bench b;
  b.key("B");
  b.hover({4, 2});
  const PreviewShapes shapes = b.w.tools.shapes(b.w.context());
  ASSERT_EQ(shapes.discs.size(), 1u);
  EXPECT_NEAR(shapes.discs[0].centre.x, 4.0f, 0.01f);
  EXPECT_EQ(shapes.discs[0].radius, b.w.toolSettings.brush.radiusM);
  b.w.pointerLeft();
  EXPECT_TRUE(b.w.tools.shapes(b.w.context()).discs.empty());
}

TEST(Brush, AnotherProjectHasNoStrokes) {
  Bench b;
  b.key("B");
  comb(b, {-10, 0}, {10, 0}, 1.0);
  EXPECT_FALSE(b.w.strokes.empty());
  b.w.flow.requestNew(Project{});
  EXPECT_TRUE(b.w.strokes.empty());
}

}  // namespace
}  // namespace windloom::editor
