#include "engine/bake/volume.hpp"

#include <gtest/gtest.h>

#include "engine/bake/voxel_field.hpp"

namespace windloom {
namespace {

constexpr float kNear = 1e-5f;

/// 3 x 2 cells over (-1, 4)..(5, 8), two layers of 2 m; cell (i, k) has velocity (10 k + i + 1, -i).
BakeHeader headerOf(Preset preset) {
  BakeHeader header;
  header.grid = makeGridMapping({2, 6}, {6, 4}, {3, 2});
  header.preset = preset;
  header.profile = {.layers = 2, .top = 4, .reference = 2, .roughness = 0.03f};
  return header;
}

std::vector<glm::vec2> someField() {
  return {{1, 0}, {2, -1}, {3, -2}, {11, 0}, {12, -1}, {13, -2}};
}

Volume volumeOf(const BakeHeader& header) {
  return {header.grid, layersOf(header, 128), header.track.quantity, header.preset};
}

std::vector<glm::vec3> blockOf(const BakeHeader& header) {
  std::vector<glm::vec3> block;
  volumeOf(header).block(someField(), block);
  return block;
}

void expectNear(glm::vec3 found, glm::vec3 wanted, float tolerance = kNear) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found[axis], wanted[axis], tolerance) << "axis " << axis;
}

// ln(1 + 1 / 0.03) / ln(1 + 2 / 0.03) and the same of 3 m.
constexpr float kLower = 0.8390172f, kUpper = 1.0950333f;

}  // namespace

TEST(Volume, GoesXThenYThenZWithYUp) {
  const BakeHeader header = headerOf(Preset::Generic);
  EXPECT_EQ(volumeOf(header).size(), glm::ivec3(3, 2, 2));
  const std::vector<glm::vec3> block = blockOf(header);
  ASSERT_EQ(block.size(), 12u);
  // Index x + 3 (layer + 2 k).
  expectNear(block[0], glm::vec3(1, 0, 0) * kLower);
  expectNear(block[2], glm::vec3(3, 0, -2) * kLower);
  expectNear(block[3 + 1], glm::vec3(2, 0, -1) * kUpper);
  expectNear(block[3 * (0 + 2 * 1) + 1], glm::vec3(12, 0, -1) * kLower, 1e-4f);
  expectNear(block[3 * (1 + 2 * 1) + 2], glm::vec3(13, 0, -2) * kUpper, 1e-4f);
}

TEST(Volume, PutsOurZOnUnrealsYInCentimetres) {
  const BakeHeader header = headerOf(Preset::Unreal);
  const Volume volume = volumeOf(header);
  EXPECT_EQ(volume.size(), glm::ivec3(3, 2, 2));
  EXPECT_EQ(volume.unit(), "cm/s");
  const std::vector<glm::vec3> block = blockOf(header);
  // Index x + 3 (k + 2 layer).
  expectNear(block[3 * 1 + 1], glm::vec3(1200, -100, 0) * kLower, 0.01f);
  expectNear(block[3 * (0 + 2 * 1) + 2], glm::vec3(300, -200, 0) * kUpper, 0.01f);
  expectNear(volume.box().min, {-100, 400, 0}, 0);
  expectNear(volume.box().max, {500, 800, 400}, 0);
}

TEST(Volume, NegatesAndReversesWhatUnityDoes) {
  const BakeHeader negX = headerOf(Preset::Unity), negZ = headerOf(Preset::UnityNegZ);
  // Cell (0, 1): the last column, or the first row.
  expectNear(blockOf(negX)[3 * (0 + 2 * 1) + 2], glm::vec3(-11, 0, 0) * kLower, 1e-4f);
  expectNear(blockOf(negX)[3 * (0 + 2 * 1) + 0], glm::vec3(-13, 0, -2) * kLower, 1e-4f);
  expectNear(blockOf(negZ)[3 * (0 + 2 * 0) + 2], glm::vec3(13, 0, 2) * kLower, 1e-4f);
  expectNear(volumeOf(negX).box().min, {-5, 0, 4}, 0);
  expectNear(volumeOf(negX).box().max, {1, 4, 8}, 0);
  expectNear(volumeOf(negZ).box().min, {-1, 0, -8}, 0);
  expectNear(volumeOf(negZ).box().max, {5, 4, -4}, 0);
}

TEST(Volume, IsFlatWithOneLayerAroundTheReferenceHeight) {
  BakeHeader header = headerOf(Preset::Generic);
  header.profile.layers = 1;
  EXPECT_EQ(volumeOf(header).size(), glm::ivec3(3, 1, 2));
  expectNear(blockOf(header)[5], {13, 0, -2}, 0);
  expectNear(volumeOf(header).box().min, {-1, 0, 4}, 0);
  expectNear(volumeOf(header).box().max, {5, 4, 8}, 0);
}

TEST(Volume, BendsAreTheSameAtEveryHeightAndNeverInCentimetres) {
  BakeHeader header = headerOf(Preset::Unreal);
  header.track = {"bend-soft", Quantity::Bend};
  EXPECT_EQ(volumeOf(header).unit(), "rad");
  expectNear(blockOf(header)[0], {1, 0, 0}, 0);
  expectNear(blockOf(header)[3 * 2], {1, 0, 0}, 0);
}

TEST(Volume, HasNoMoreLayersThanItsFormat) {
  BakeHeader header = headerOf(Preset::Generic);
  header.profile.layers = 100;
  const VolumeLayers layers = layersOf(header, 4);
  ASSERT_EQ(layers.factors.size(), 4u);
  EXPECT_EQ(layers.high, 4.0f);
  EXPECT_FLOAT_EQ(layers.factors[3], header.profile.at(3.5f));
}

TEST(Volume, StaysWithinTheRangeOfHalfFloats) {
  BakeHeader header = headerOf(Preset::Unreal);
  header.profile.layers = 1;
  std::vector<glm::vec3> block;
  volumeOf(header).block(std::vector<glm::vec2>(6, {2000, -1000}), block);
  expectNear(block[0], {65504, -32752, 0}, 0.1f);
}

TEST(FittedField, KeepsTheShapeAndTheMean) {
  EXPECT_EQ(fittedResolution({1000, 1000}, 128), glm::ivec2(128, 128));
  EXPECT_EQ(fittedResolution({1000, 250}, 128), glm::ivec2(128, 32));
  EXPECT_EQ(fittedResolution({3000, 1}, 128), glm::ivec2(128, 1));
  EXPECT_EQ(fittedResolution({128, 7}, 128), glm::ivec2(128, 7));
  FittedField field(makeGridMapping({0, 0}, {8, 4}, {8, 4}), 4);
  EXPECT_EQ(field.grid().resolution, glm::ivec2(4, 2));
  EXPECT_EQ(field.grid().cellSize, glm::vec2(2, 2));
  EXPECT_EQ(field.grid().minCorner, glm::vec2(-4, -2));
  std::vector<glm::vec2> cells;
  for (int i = 0; i < 32; ++i) cells.emplace_back(i, -i);
  const std::span<const glm::vec2> fitted = field.of(cells);
  ASSERT_EQ(fitted.size(), 8u);
  EXPECT_EQ(fitted[0], glm::vec2(4.5f, -4.5f));  // of 0, 1, 8, 9
  EXPECT_EQ(fitted[7], glm::vec2(26.5f, -26.5f));
}

TEST(VoxelField, LeavesSquareCellsAsTheyAre) {
  BakeHeader header = headerOf(Preset::Generic);  // cells of 2 m
  VoxelField field(header);
  EXPECT_EQ(field.side(), 2.0f);
  EXPECT_EQ(field.volume().size(), glm::ivec3(3, 2, 2));
  std::vector<glm::vec3> block;
  field.block(someField(), block);
  EXPECT_EQ(block, blockOf(header));
}

TEST(VoxelField, InterpolatesBetweenCellsThatAreNotSquare) {
  BakeHeader header = headerOf(Preset::Unreal);
  header.grid = makeGridMapping({2, 6}, {6, 8}, {3, 2});  // 2 m x 4 m
  header.profile.top = 5;
  VoxelField field(header);
  EXPECT_EQ(field.side(), 200.0f);
  EXPECT_EQ(field.volume().size(), glm::ivec3(3, 4, 3));
  expectNear(field.volume().box().max, {500, 1000, 600}, 0);
  std::vector<glm::vec3> block;
  field.block(someField(), block);
  const float factor = 100 * header.profile.at(1.0f);
  const float x[] = {1, 3.5f, 8.5f, 11};  // centres at 1, 3, 5, 7 m between those of the cells at 2 and 6 m
  for (int k = 0; k < 4; ++k) expectNear(block[static_cast<std::size_t>(3 * k)], glm::vec3(x[k], 0, 0) * factor, 0.01f);
}

TEST(VoxelField, WrapsWhereTheFieldRepeats) {
  BakeHeader header = headerOf(Preset::Generic);
  header.grid = makeGridMapping({2, 6}, {6, 8}, {3, 2});
  header.profile.layers = 1;
  header.periodicZ = true;
  VoxelField field(header);
  EXPECT_EQ(field.volume().size(), glm::ivec3(3, 1, 4));
  expectNear(field.volume().box().min, {-1, 1, 2}, 0);
  std::vector<glm::vec3> block;
  field.block(someField(), block);
  expectNear(block[0], {3.5f, 0, 0}, kNear);  // a quarter of cell (0, 1), behind it over the border
}

}  // namespace windloom
