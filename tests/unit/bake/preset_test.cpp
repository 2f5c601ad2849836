#include "engine/bake/preset.hpp"

#include <gtest/gtest.h>

namespace windloom {

// A field from (-10, 2) to (30, 22) m: its low corner isn't the mirror of its high one.
constexpr glm::vec2 kCorner{-10.0f, 2.0f}, kSize{40.0f, 20.0f};

TEST(Preset, FindsAllByName) {
  for (const PresetRules& rules : presets()) EXPECT_EQ(presetNamed(rules.name), rules.preset);
  EXPECT_FALSE(presetNamed("cryengine"));
}

TEST(Preset, GenericAndGodotKeepOurFrame) {
  for (const Preset preset : {Preset::Generic, Preset::Godot}) {
    const PresetRules& rules = rulesOf(preset);
    EXPECT_EQ(rules.handedness, "right");
    EXPECT_EQ(rules.up, "+Y");
    EXPECT_EQ(boundsIn(rules, kCorner, kSize).min, glm::vec2(-10, 2));
    EXPECT_EQ(boundsIn(rules, kCorner, kSize).max, glm::vec2(30, 22));
    EXPECT_EQ(velocityIn(rules, {3, -4}), glm::vec2(3, -4));
    EXPECT_EQ(cellOfPixel(rules, {0, 0}, {40, 20}), glm::ivec2(0, 0));
  }
}

TEST(Preset, UnrealIsLeftHandedZUpInCentimetres) {
  const PresetRules& rules = rulesOf(Preset::Unreal);
  EXPECT_EQ(rules.handedness, "left");
  EXPECT_EQ(rules.up, "+Z");
  EXPECT_EQ(rules.axes[1], "y");
  EXPECT_EQ(rules.unitsPerMetre, 100.0f);
  EXPECT_EQ(rules.speedUnit, "cm/s");
  EXPECT_EQ(boundsIn(rules, kCorner, kSize).min, glm::vec2(-1000, 200));
  EXPECT_EQ(boundsIn(rules, kCorner, kSize).max, glm::vec2(3000, 2200));
  EXPECT_EQ(velocityIn(rules, {3, -4}), glm::vec2(3, -4));
  EXPECT_EQ(cellOfPixel(rules, {0, 0}, {40, 20}), glm::ivec2(0, 0));
}

TEST(Preset, UnityMirrorsXAndStartsImagesAtHighZ) {
  const PresetRules& rules = rulesOf(Preset::Unity);
  EXPECT_EQ(rules.handedness, "left");
  EXPECT_EQ(rules.up, "+Y");
  EXPECT_EQ(boundsIn(rules, kCorner, kSize).min, glm::vec2(-30, 2));
  EXPECT_EQ(boundsIn(rules, kCorner, kSize).max, glm::vec2(10, 22));
  EXPECT_EQ(velocityIn(rules, {3, -4}), glm::vec2(-3, -4));
  // The top left pixel lies at Unity's low x, our high x, and at high z.
  EXPECT_EQ(cellOfPixel(rules, {0, 0}, {40, 20}), glm::ivec2(39, 19));
  EXPECT_EQ(cellOfPixel(rules, {39, 19}, {40, 20}), glm::ivec2(0, 0));
}

TEST(Preset, UnityMayMirrorZInstead) {
  const PresetRules& rules = rulesOf(Preset::UnityNegZ);
  EXPECT_EQ(boundsIn(rules, kCorner, kSize).min, glm::vec2(-10, -22));
  EXPECT_EQ(boundsIn(rules, kCorner, kSize).max, glm::vec2(30, -2));
  EXPECT_EQ(velocityIn(rules, {3, -4}), glm::vec2(3, 4));
  EXPECT_EQ(cellOfPixel(rules, {0, 0}, {40, 20}), glm::ivec2(0, 0)) << "its high z is our low one";
}

}  // namespace windloom
