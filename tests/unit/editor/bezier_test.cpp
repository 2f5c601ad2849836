// Bezier grass in the editor: switching to it, and what the inspector shows then.
#include "editor/core/inspector.hpp"
#include "editor_bench.hpp"

namespace windloom::editor {
namespace {

bool relevant(const Bench& b, InspectorKind kind, std::string_view key) {
  for (const InspectorRow& row : inspect(b.project(), {kind, {}}).rows)
    if (row.info.key == key) return row.relevant;
  ADD_FAILURE() << "no row " << key;
  return false;
}

bool shown(const Bench& b, std::string_view key) {
  return relevant(b, InspectorKind::Bezier, key);
}

void set(Bench& b, std::string_view key, const char* text) {
  EXPECT_TRUE(b.w.apply(setFromText(b.project(), {InspectorKind::Bezier}, key, text))) << key;
}

}  // namespace

TEST(BezierGrass, Key2SwitchesToItAndAllElseStays) {
  Bench b;
  b.draw({-10, 0}, {10, 0});
  b.key("Q");
  b.w.windSeconds = 12.5;
  b.w.camera.yaw = 33;
  const EditorCamera camera = b.w.camera;
  const Project before = b.project();
  const std::size_t steps = b.steps();
  EXPECT_TRUE(b.key("2"));
  EXPECT_EQ(b.project().grass->kind, GrassKind::Bezier);
  EXPECT_TRUE(b.w.actions.checked("grass.bezier"));
  EXPECT_FALSE(b.w.actions.checked("grass.instanced"));
  EXPECT_EQ(b.steps(), steps + 1);
  Project same = b.project();
  same.grass = before.grass;
  EXPECT_TRUE(same.sameAs(before)) << "wind, field and all others are shared: nothing starts again";
  EXPECT_EQ(b.w.camera.yaw, camera.yaw);
  EXPECT_EQ(b.w.camera.target, camera.target);
  EXPECT_EQ(b.w.windSeconds, 12.5);
  b.key("2");
  EXPECT_EQ(b.steps(), steps + 1) << "it is that already";
  b.key("1");
  EXPECT_EQ(b.project().grass->kind, GrassKind::Instanced);
  b.key("Ctrl+Z");
  EXPECT_EQ(b.project().grass->kind, GrassKind::Bezier);
}

TEST(BezierGrass, RowsOfTheOtherGrassMeanNothingToIt) {
  Bench b;
  const char* others[] = {"deformation", "windFactor", "droop/down", "droop/forward",
                          "restBlend",   "flutter",    "swing/rate", "interacting"};
  const char* common[] = {"kind",      "density",     "height",      "width",
                          "stiffness", "colours/tip", "slope/limit", "maps/density"};
  b.key("2");
  for (const char* key : others) EXPECT_FALSE(relevant(b, InspectorKind::Grass, key)) << key;
  for (const char* key : common) EXPECT_TRUE(relevant(b, InspectorKind::Grass, key)) << key;
  b.key("1");
  EXPECT_TRUE(relevant(b, InspectorKind::Grass, "droop/down"));
}

TEST(BezierGrass, ItsRowsFollowWhatTheOthersChoose) {
  Bench b;
  EXPECT_TRUE(shown(b, "blade/tip"));
  set(b, "blade/form", "triangle");
  EXPECT_FALSE(shown(b, "blade/tip"));
  EXPECT_FALSE(shown(b, "wind/waveLength"));
  EXPECT_TRUE(shown(b, "wind/strength"));
  set(b, "wind/source", "both");
  EXPECT_TRUE(shown(b, "wind/waveLength"));
  EXPECT_FALSE(shown(b, "gravity/centre"));
  set(b, "gravity/centreBlend", "0.5");
  EXPECT_TRUE(shown(b, "gravity/centre"));
  EXPECT_TRUE(shown(b, "gravity/direction"));
  set(b, "gravity/centreBlend", "1");
  EXPECT_FALSE(shown(b, "gravity/direction"));
  set(b, "tufts/share", "0");
  EXPECT_FALSE(shown(b, "tufts/radius"));
  EXPECT_TRUE(shown(b, "collision/fade"));
  set(b, "collision/strength", "0");
  EXPECT_FALSE(shown(b, "collision/fade"));
}

}  // namespace windloom::editor
