#include "engine/render/overlay_settings.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace windloom {
namespace {

Result<Overlays> named(std::vector<std::string> names) {
  return overlaysByName(names);
}

TEST(OverlayNames, SwitchOnWhatIsNamedAndNothingElse) {
  const Result<Overlays> overlays = named({"streamlines", "lic"});
  ASSERT_TRUE(overlays.ok());
  EXPECT_TRUE(overlays->streamlines);
  EXPECT_EQ(overlays->map, GroundMap::Lic);
  EXPECT_FALSE(overlays->arrows);
  EXPECT_FALSE(overlays->vectors);
  EXPECT_FALSE(named({"none"})->any());
}

TEST(OverlayNames, EveryKindCanBeNamed) {
  for (const OverlayKind& kind : overlayKinds()) {
    const Result<Overlays> overlays = named({std::string(kind.name)});
    ASSERT_TRUE(overlays.ok()) << kind.name;
    EXPECT_TRUE(isOn(*overlays, kind)) << kind.name;
    int on = 0;
    for (const OverlayKind& other : overlayKinds()) on += isOn(*overlays, other) ? 1 : 0;
    EXPECT_EQ(on, 1) << kind.name;
  }
}

TEST(OverlayNames, RefuseUnknownOnesWithTheList) {
  const Result<Overlays> overlays = named({"arrows", "smell"});
  ASSERT_FALSE(overlays.ok());
  EXPECT_EQ(overlays.error().kind, ErrorKind::Usage);
  const std::string text = overlays.error().text();
  EXPECT_NE(text.find("'smell'"), std::string::npos) << text;
  for (const OverlayKind& kind : overlayKinds()) EXPECT_NE(text.find(kind.name), std::string::npos) << kind.name;
}

TEST(OverlayNames, RefuseASecondMapOfTheGround) {
  const Result<Overlays> overlays = named({"speed", "arrows", "divergence"});
  ASSERT_FALSE(overlays.ok());
  EXPECT_NE(overlays.error().text().find("'speed' and 'divergence'"), std::string::npos) << overlays.error().text();
  EXPECT_TRUE(named({"speed", "speed"}).ok());
}

TEST(OverlaySwitches, AMapTakesThePlaceOfAnother) {
  Overlays overlays;
  setOn(overlays, *findOverlay("speed"), true);
  setOn(overlays, *findOverlay("vorticity"), true);
  EXPECT_EQ(overlays.map, GroundMap::Vorticity);
  setOn(overlays, *findOverlay("speed"), false);
  EXPECT_EQ(overlays.map, GroundMap::Vorticity) << "speed was off already";
  setOn(overlays, *findOverlay("vorticity"), false);
  EXPECT_EQ(overlays.map, GroundMap::None);
}

}  // namespace
}  // namespace windloom
