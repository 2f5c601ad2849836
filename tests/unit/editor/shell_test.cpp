// Shell grass in the editor: switching to it, what the inspector shows then, what refusals and the history say of it.
#include <algorithm>

#include "editor/core/history.hpp"
#include "editor/core/inspector.hpp"
#include "editor/core/project_changes.hpp"
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
  return relevant(b, InspectorKind::Shell, key);
}

Result<Edit> setting(Bench& b, std::string_view key, const char* text) {
  return setFromText(b.project(), {InspectorKind::Shell}, key, text);
}

std::shared_ptr<const GrassMap> picture(std::size_t pixels) {
  auto made = std::make_shared<GrassMap>();
  made->file = "assets/blades.png";
  made->size = {static_cast<int>(pixels), 1};
  made->pixels.resize(4 * pixels);
  return made;
}

}  // namespace

TEST(ShellGrass, Key3SwitchesToItAndAllElseStays) {
  Bench b;
  b.draw({-10, 0}, {10, 0});
  b.key("Q");
  b.w.windSeconds = 12.5;
  const Project before = b.project();
  const std::size_t steps = b.steps();
  EXPECT_TRUE(b.key("3"));
  EXPECT_EQ(b.project().grass->kind, GrassKind::Shell);
  EXPECT_TRUE(b.w.actions.checked("grass.shell"));
  EXPECT_FALSE(b.w.actions.checked("grass.instanced"));
  EXPECT_EQ(b.steps(), steps + 1);
  Project same = b.project();
  same.grass = before.grass;
  EXPECT_TRUE(same.sameAs(before)) << "wind, field and all others are shared: nothing starts again";
  EXPECT_EQ(b.w.windSeconds, 12.5);
  b.key("2");
  EXPECT_EQ(b.project().grass->kind, GrassKind::Bezier);
  b.key("4");
  EXPECT_EQ(b.project().grass->kind, GrassKind::None);
  b.key("Ctrl+Z");
  b.key("Ctrl+Z");
  EXPECT_EQ(b.project().grass->kind, GrassKind::Shell);
}

TEST(ShellGrass, RowsOfSingleBladesMeanNothingToIt) {
  Bench b;
  b.key("3");
  for (const char* key : {"deformation", "stiffnessVariation", "droop/down", "droop/forward", "restBlend", "swing/rate",
                          "swing/exponent", "interacting"})
    EXPECT_FALSE(relevant(b, InspectorKind::Grass, key)) << key;
  for (const char* key :
       {"kind", "density", "height", "heightVariation", "width", "stiffness", "clumping", "windFactor", "flutter",
        "colours/tip", "dryness", "shadow/min", "slope/limit", "maps/density"})
    EXPECT_TRUE(relevant(b, InspectorKind::Grass, key)) << key;
}

TEST(ShellGrass, ItsRowsFollowWhatTheOthersChoose) {
  Bench b;
  EXPECT_FALSE(shown(b, "wind/sourcePeriod"));
  EXPECT_TRUE(shown(b, "wind/source"));
  EXPECT_TRUE(shown(b, "wind/strength"));
  EXPECT_TRUE(b.w.apply(setting(b, "wind/source", "both")));
  EXPECT_TRUE(shown(b, "wind/sourcePeriod"));
  EXPECT_TRUE(shown(b, "wind/strength"));
  EXPECT_TRUE(b.w.apply(setting(b, "wind/source", "source")));
  EXPECT_TRUE(shown(b, "wind/sourcePosition"));
  EXPECT_FALSE(shown(b, "wind/strength"));
  for (const char* key : {"texture/fullness", "texture/thickness", "texture/taper"}) EXPECT_TRUE(shown(b, key)) << key;
  EXPECT_TRUE(b.w.apply(setting(b, "texture/file", "assets/blades.png")));
  for (const char* key : {"texture/fullness", "texture/thickness", "texture/taper"}) EXPECT_FALSE(shown(b, key)) << key;
  EXPECT_TRUE(shown(b, "texture/heightCurve"));
}

TEST(ShellGrass, RefusalsAndChangesNameIt) {
  Bench b;
  const Project before = b.project();
  b.w.apply(setting(b, "bend/overBend", "2.5"));
  EXPECT_NE(b.w.message().text.find("Over-bending: found 2.5, expected a number from 1 to 2"), std::string::npos)
      << b.w.message().text;
  b.w.apply(setting(b, "texture/file", "../blades.png"));
  EXPECT_NE(b.w.message().text.find("The shell grass' texture file"), std::string::npos) << b.w.message().text;
  EXPECT_EQ(b.steps(), 0u);
  b.w.apply(setting(b, "shells", "12"));
  const std::vector<std::string> lines = describeChanges(before, b.project());
  EXPECT_NE(std::ranges::find(lines, "Shell grass changed: shells"), lines.end());
}

TEST(ShellGrass, OnSurfacesItGrowsAndOtherGrassIsTold) {
  Bench b;
  EXPECT_TRUE(b.w.actions.run("add.sphere"));
  EXPECT_NE(b.w.message().text.find("keys 2 and 3"), std::string::npos) << b.w.message().text;
  Bench shells;
  shells.key("3");
  EXPECT_TRUE(shells.w.actions.run("add.sphere"));
  EXPECT_EQ(shells.w.message().text.find("grow on surfaces"), std::string::npos) << shells.w.message().text;
}

TEST(ShellGrass, TheHistoryCountsItsSettingsAndItsPictureOnce) {
  constexpr std::size_t kPixels = 100'000;
  Project project;
  History history(project);
  const std::size_t empty = history.bytes();
  ShellSettings shell;
  shell.pixels = picture(kPixels);
  shell.texture = shell.pixels->file;
  project.shell = std::make_shared<ShellSettings>(shell);
  history.push(project, "Set picture", {});
  const std::size_t with = history.bytes();
  EXPECT_GE(with, empty + 4 * kPixels + sizeof(ShellSettings));
  shell.shells = 20;
  project.shell = std::make_shared<ShellSettings>(shell);
  history.push(project, "Set shells", {});
  EXPECT_GE(history.bytes(), with + sizeof(ShellSettings));
  EXPECT_LT(history.bytes(), with + 4 * kPixels) << "shared";
}

}  // namespace windloom::editor
