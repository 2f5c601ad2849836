#include "engine/bake/target_frame.hpp"

#include <gtest/gtest.h>

namespace windloom {
namespace {

/// 3 x 2 cells of 2 m around (1, 0); cell (i, k) blows (i + 1, 10 (k + 1)) m/s.
BakeHeader header(Preset preset, FlowSpace space = FlowSpace::World) {
  BakeHeader header;
  header.grid = makeGridMapping({1, 0}, {6, 4}, {3, 2});
  header.fullScale = 20;
  header.preset = preset;
  header.space = space;
  return header;
}

std::vector<glm::vec2> imageOf(const BakeHeader& header) {
  std::vector<glm::vec2> cells, out;
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < 3; ++i) cells.emplace_back(i + 1, 10 * (k + 1));
  }
  TargetFrame(header).image(cells, out);
  return out;
}

using Cells = std::vector<glm::vec2>;

}  // namespace

TEST(TargetFrame, TurnsWorldVelocityIntoEachPresetsAxes) {
  const Cells ours = {{1, 10}, {2, 10}, {3, 10}, {1, 20}, {2, 20}, {3, 20}};
  EXPECT_EQ(imageOf(header(Preset::Generic)), ours);
  EXPECT_EQ(imageOf(header(Preset::Godot)), ours);
  Cells centimetres = ours;
  for (glm::vec2& v : centimetres) v *= 100.0f;
  EXPECT_EQ(imageOf(header(Preset::Unreal)), centimetres);
  // x negated: columns reversed; the first row is high z.
  EXPECT_EQ(imageOf(header(Preset::Unity)), (Cells{{-3, 20}, {-2, 20}, {-1, 20}, {-3, 10}, {-2, 10}, {-1, 10}}));
  // z negated: the first row is high in the target, so low in ours.
  EXPECT_EQ(imageOf(header(Preset::UnityNegZ)), (Cells{{1, -10}, {2, -10}, {3, -10}, {1, -20}, {2, -20}, {3, -20}}));
}

TEST(TargetFrame, CountsTextureCoordinatesASecond) {
  for (const Preset preset : {Preset::Generic, Preset::Unreal}) {
    const Cells flow = imageOf(header(preset, FlowSpace::Uv));
    EXPECT_EQ(flow[0], glm::vec2(1.0f / 6, 10.0f / 4)) << "a field's width and height a texture";
  }
  EXPECT_EQ(imageOf(header(Preset::Unity, FlowSpace::Uv))[0], glm::vec2(-3.0f / 6, 20.0f / 4))
      << "v runs up the file there, as z does";
  EXPECT_EQ(TargetFrame(header(Preset::Unity, FlowSpace::Uv)).fullScale(), 5.0f);
  EXPECT_EQ(TargetFrame(header(Preset::Unity, FlowSpace::Uv)).unit(), "uv/s");
}

TEST(TargetFrame, LeavesAnglesInRadians) {
  BakeHeader bend = header(Preset::Unreal);
  bend.track = {"bend-soft", Quantity::Bend};
  EXPECT_EQ(imageOf(bend)[0], glm::vec2(1, 10));
  EXPECT_EQ(TargetFrame(bend).unit(), "rad");
  bend.preset = Preset::Unity;
  bend.space = FlowSpace::Uv;
  EXPECT_EQ(imageOf(bend)[0], glm::vec2(-3, 20)) << "a direction in the world whatever the flow's space";
}

TEST(Codes, AreSymmetricAroundStillAir) {
  EXPECT_EQ(signedCode8(0), 128);
  EXPECT_EQ(signedCode8(1), 255);
  EXPECT_EQ(signedCode8(-1), 1);
  EXPECT_EQ(signedCode16(0), 32768);
  EXPECT_EQ(signedCode16(1), 65535);
  EXPECT_EQ(signedCode16(-1), 1);
  EXPECT_EQ(unsignedCode8(1), 255);
  EXPECT_EQ(unsignedCode16(2), 65535);
}

TEST(Codes, ShortenWithoutTurningAndCountIt) {
  long long clipped = 0;
  const glm::vec2 part = partOf({30, 40}, 10, clipped);
  EXPECT_NEAR(part.x, 0.6f, 1e-6f);
  EXPECT_NEAR(part.y, 0.8f, 1e-6f);
  EXPECT_EQ(clipped, 1);
  EXPECT_EQ(partOf({3, 4}, 10, clipped), glm::vec2(0.3f, 0.4f));
  EXPECT_EQ(clipped, 1);
}

TEST(HeightProfile, FollowsTheLogarithmicLaw) {
  const HeightProfile profile{.layers = 4, .top = 8, .reference = 2, .roughness = 0.1f};
  EXPECT_EQ(profile.at(0), 0.0f);
  EXPECT_EQ(profile.at(-1), 0.0f);
  EXPECT_FLOAT_EQ(profile.at(2), 1.0f);
  EXPECT_NEAR(profile.at(10), std::log(101.0f) / std::log(21.0f), 1e-5f);
  EXPECT_FLOAT_EQ(profile.heightOf(0), 1.0f);
  EXPECT_FLOAT_EQ(profile.heightOf(3), 7.0f);
  EXPECT_FLOAT_EQ((HeightProfile{.layers = 1, .reference = 3}.heightOf(0)), 3.0f);
}

}  // namespace windloom
