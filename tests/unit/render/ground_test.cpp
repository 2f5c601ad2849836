#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "engine/render/frame_block.hpp"
#include "engine/render/framing.hpp"
#include "engine/render/ground_light.hpp"
#include "engine/render/ground_tiles.hpp"
#include "engine/render/solids.hpp"
#include "tests/height_fixture.hpp"

namespace windloom {
namespace {

using testing::heightsFrom;
using testing::terrainOf;

float hills(glm::vec2 p) {
  return 6.0f * std::sin(0.11f * p.x) * std::cos(0.13f * p.y) + (p.x > 20 ? 0.2f * std::sin(3.0f * p.y) : 0.0f);
}

GroundSelection selectionFor(const HeightField& field, const ViewCamera& camera, float pixels, long most = 10'000'000) {
  Project project;
  FrameInput input;
  input.project = &project;
  input.camera = camera;
  return selectGroundTiles(field, measureGroundTiles(field), makeFrameBlock(input, defaultLight()), 1000, pixels, most);
}

std::map<std::pair<unsigned, unsigned>, GroundTile> byPlace(const GroundSelection& selection) {
  std::map<std::pair<unsigned, unsigned>, GroundTile> tiles;
  for (const auto& level : selection.levels) {
    for (const GroundTile& tile : level) EXPECT_TRUE(tiles.emplace(std::pair(tile.x, tile.z), tile).second);
  }
  return tiles;
}

ViewCamera over(glm::vec3 position, glm::vec3 target) {
  ViewCamera camera;
  camera.position = position;
  camera.target = target;
  return camera;
}

}  // namespace

TEST(GroundTiles, NeighboursAgreeOnTheCoarserLattice) {
  const auto field = heightsFrom({300, 211}, {120, 90}, hills);
  const auto tiles = byPlace(selectionFor(*field, over({30, 12, 40}, {0, 0, 0}), 1.0f));
  ASSERT_GT(tiles.size(), 20u);
  int mixed = 0;
  for (const auto& [place, tile] : tiles) {
    const std::pair<unsigned, unsigned> right{place.first + 1, place.second}, down{place.first, place.second + 1};
    if (const auto next = tiles.find(right); next != tiles.end()) {
      const unsigned coarser = std::max(tile.level, next->second.level);
      EXPECT_EQ(tile.around >> 8 & 255u, coarser);
      EXPECT_EQ(next->second.around & 255u, coarser);
      mixed += tile.level != next->second.level;
    }
    if (const auto next = tiles.find(down); next != tiles.end()) {
      const unsigned coarser = std::max(tile.level, next->second.level);
      EXPECT_EQ(tile.around >> 24 & 255u, coarser);
      EXPECT_EQ(next->second.around >> 16 & 255u, coarser);
    }
  }
  EXPECT_GT(mixed, 0) << "the picture has several levels";
}

TEST(GroundTiles, FlatPartsCostTwoTrianglesATileAndNearHillsMore) {
  const auto flat = heightsFrom({257, 257}, {100, 100}, [](glm::vec2 p) { return 0.1f * p.x; });
  const GroundSelection plain = selectionFor(*flat, over({0, 20, 60}, {0, 0, 0}), 1.0f);
  EXPECT_TRUE(plain.levels[0].empty());
  EXPECT_FALSE(plain.levels[5].empty());
  const auto rough = heightsFrom({257, 257}, {100, 100}, [](glm::vec2 p) { return std::sin(4.0f * p.x); });
  const GroundSelection near = selectionFor(*rough, over({0, 2, 0}, {5, 1, 0}), 1.0f);
  EXPECT_FALSE(near.levels[0].empty());
  EXPECT_GT(near.triangles, 10'000);
  EXPECT_LE(selectionFor(*rough, over({0, 2, 0}, {5, 1, 0}), 1.0f, 5'000).triangles, 5'000) << "a limit is kept";
}

TEST(GroundTiles, WhatIsBehindTheCameraIsLeftOut) {
  const auto field = heightsFrom({513, 513}, {200, 200}, hills);
  const auto tiles = byPlace(selectionFor(*field, over({0, 10, 0}, {30, 8, 0}), 1.0f));
  EXPECT_FALSE(tiles.contains({2, 8})) << "90 m behind";
  EXPECT_TRUE(tiles.contains({14, 9})) << "90 m ahead";
}

TEST(GroundLight, HillsCastShadowsAsFarAsTheSunSays) {
  // A ridge 10 m high at x = 0; the sun stands at 45 degrees over +x.
  const auto ridge = heightsFrom({401, 5}, {100, 10}, [](glm::vec2 p) { return std::abs(p.x) < 0.5f ? 10.0f : 0.0f; });
  const auto light = makeGroundLight(*ridge, glm::normalize(glm::vec3(1, 1, 0)));
  const auto shadowAt = [&](float x) { return light[static_cast<std::size_t>(2 * 401 + int(std::lround((x + 50) * 4)))].z; };
  EXPECT_LT(shadowAt(20), 0.0f) << "on the sunny side";
  EXPECT_NEAR(shadowAt(-4), 6.5f, 0.3f);
  EXPECT_NEAR(shadowAt(-9), 1.5f, 0.3f);
  EXPECT_LT(shadowAt(-12), 0.0f) << "beyond the shadow's end";
}

TEST(GroundLight, NormalsLeanAwayFromTheSlope) {
  const auto slope = heightsFrom({9, 9}, {8, 8}, [](glm::vec2 p) { return 0.75f * p.y; });
  for (const glm::vec4& value : makeGroundLight(*slope, glm::normalize(glm::vec3(-0.6f, 0.4f, -0.7f)))) {
    EXPECT_NEAR(value.x, 0.0f, 1e-5f);
    EXPECT_NEAR(value.y, -0.6f, 1e-4f);
  }
}

TEST(SolidsOnHills, StandOnTheLowestGroundAndRiseOverTheirCentre) {
  const auto slope = heightsFrom({101, 101}, {100, 100}, [](glm::vec2 p) { return 10.0f + 0.2f * p.x; });
  Obstacle stone;
  stone.centre = {10, 0};
  stone.radius = 5;
  stone.height = 3;
  const Solid solid = makeSolids({stone}, slope.get()).front();
  EXPECT_NEAR(solid.level.x, 11.0f, 1e-3f);
  EXPECT_NEAR(solid.level.y, 15.0f, 1e-3f);
  const Solid flat = makeSolids({stone}).front();
  EXPECT_EQ(glm::vec2(flat.level), glm::vec2(0, 3));
}

TEST(FramingOnHills, ShowsEveryCornerOfTheField) {
  const auto field = heightsFrom({65, 65}, {140, 140}, [](glm::vec2 p) { return 20.0f + 15.0f * std::sin(0.08f * p.x); });
  for (const ViewCamera& camera : {frameField({}, field.get()), frameFieldFromAbove({}, field.get())}) {
    Project project;
    FrameInput input;
    input.project = &project;
    input.camera = camera;
    const FrameBlock block = makeFrameBlock(input, defaultLight());
    for (const glm::vec2 corner : {glm::vec2(-50, -50), glm::vec2(50, -50), glm::vec2(-50, 50), glm::vec2(50, 50), glm::vec2(19, 0)}) {
      const glm::vec3 at(corner.x, heightAt(*field, corner), corner.y);
      for (const glm::vec4& plane : block.frustum) EXPECT_GE(glm::dot(glm::vec3(plane), at) + plane.w, 0.0f);
    }
  }
}

}  // namespace windloom
