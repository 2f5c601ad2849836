#include <gtest/gtest.h>

#include "engine/bake/frame_writer.hpp"
#include "engine/io/image.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace {

constexpr glm::ivec2 kResolution{6, 4};

/// The first flow map of a field in a preset, with 10 m/s as full scale.
Image flowMapOf(const std::vector<glm::vec2>& field, Preset preset) {
  const TemporaryFolder folder;
  BakeHeader header;
  header.grid = makeGridMapping({0, 0}, {6, 4}, kResolution);
  header.fullScale = 10.0f;
  header.preset = preset;
  Result<std::unique_ptr<FrameWriter>> writer = writerKindNamed("png")->open(header, folder.path());
  EXPECT_TRUE(writer);
  EXPECT_TRUE((*writer)->add(0, field));
  const Result<std::vector<BakedFile>> files = (*writer)->finish();
  EXPECT_EQ(files->at(0).path, "flow.0000.png");
  return readPng(folder.path() / "flow.0000.png").value();
}

std::vector<glm::vec2> constant(glm::vec2 velocity) {
  return std::vector<glm::vec2>(24, velocity);
}

std::vector<int> pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = image.at(x, y);
  return {p[0], p[1], p[2], p[3]};
}

}  // namespace

TEST(FlowMap, StillAirIsExactlyCode128) {
  EXPECT_EQ(pixel(flowMapOf(constant({0, 0}), Preset::Generic), 2, 2), (std::vector<int>{128, 128, 0, 255}));
}

TEST(FlowMap, HoldsWorldVelocityWithTheSignsOfThePreset) {
  // 6 and -8 of 10 m/s: codes 128 + 76 and 128 - 102; speed is full.
  for (const Preset preset : {Preset::Generic, Preset::Godot, Preset::Unreal}) {
    EXPECT_EQ(pixel(flowMapOf(constant({6, -8}), preset), 3, 1), (std::vector<int>{204, 26, 255, 255}));
  }
  EXPECT_EQ(pixel(flowMapOf(constant({6, -8}), Preset::Unity), 3, 1), (std::vector<int>{52, 26, 255, 255}));
}

TEST(FlowMap, PutsEachCellWhereThePresetWantsIt) {
  std::vector<glm::vec2> field = constant({0, 0});
  field[1 * 6 + 2] = {10, 0};  // cell (2, 1)
  for (const Preset preset : {Preset::Generic, Preset::Godot, Preset::Unreal}) {
    EXPECT_EQ(pixel(flowMapOf(field, preset), 2, 1), (std::vector<int>{255, 128, 255, 255}));
  }
  EXPECT_EQ(pixel(flowMapOf(field, Preset::Unity), 3, 2), (std::vector<int>{1, 128, 255, 255}));
  EXPECT_EQ(pixel(flowMapOf(field, Preset::Unity), 2, 1), (std::vector<int>{128, 128, 0, 255}));
}

TEST(FlowMap, SlowsWhatIsOverTheScaleWithoutTurningIt) {
  EXPECT_EQ(pixel(flowMapOf(constant({30, 40}), Preset::Generic), 0, 0), (std::vector<int>{204, 230, 255, 255}));
}

TEST(FlowMap, NumbersFramesWithFourDigits) {
  const TemporaryFolder folder;
  BakeHeader header;
  header.grid = makeGridMapping({0, 0}, {6, 4}, kResolution);
  Result<std::unique_ptr<FrameWriter>> writer = writerKindNamed("png")->open(header, folder.path());
  ASSERT_TRUE((*writer)->add(7, constant({0, 0})));
  ASSERT_TRUE((*writer)->add(12345, constant({0, 0})));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "flow.0007.png"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "flow.12345.png"));
}

}  // namespace windloom
