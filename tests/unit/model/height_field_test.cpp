#include "engine/model/height_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/model/asset_names.hpp"
#include "engine/model/edit.hpp"
#include "engine/model/validate.hpp"
#include "tests/height_fixture.hpp"

namespace windloom {
namespace {

using testing::heightsFrom;
using testing::terrainOf;

/// The first crossing from above to below, by very small steps.
std::optional<float> bruteForce(const HeightField& field, glm::vec3 origin, glm::vec3 direction, float reach) {
  const auto above = [&](double t) {
    const glm::dvec3 at = glm::dvec3(origin) + t * glm::dvec3(direction);
    return at.y - static_cast<double>(heightAt(field, {float(at.x), float(at.z)}));
  };
  double before = 0;
  for (double t = 0.01; t < static_cast<double>(reach); t += 0.01) {
    if (above(before) >= 0 && above(t) < 0) return static_cast<float>(t);
    before = t;
  }
  return std::nullopt;
}

float hills(glm::vec2 p) {
  return 6.0f * std::sin(0.31f * p.x) * std::cos(0.23f * p.y) + 3.0f * std::sin(0.9f * p.x + p.y);
}

}  // namespace

TEST(HeightField, GivesSamplesAtTheirPlacesAndIsStraightBetween) {
  const auto field =
      heightsFrom({5, 3}, {8, 4}, [](glm::vec2 p) { return 3.0f + 2.0f * p.x - p.y + 0.5f * p.x * p.y; });
  for (const glm::vec2 p :
       {glm::vec2(-4, -2), glm::vec2(4, 2), glm::vec2(0, 0), glm::vec2(1.3f, -0.7f), glm::vec2(-3.9f, 1.99f)}) {
    EXPECT_NEAR(heightAt(*field, p), 3.0f + 2.0f * p.x - p.y + 0.5f * p.x * p.y, 1e-4f);
  }
}

TEST(HeightField, EdgeGoesOnOutside) {
  const auto field = heightsFrom({9, 9}, {16, 16}, hills);
  EXPECT_FLOAT_EQ(heightAt(*field, {-500, 3}), heightAt(*field, {-8, 3}));
  EXPECT_FLOAT_EQ(heightAt(*field, {5, 900}), heightAt(*field, {5, 8}));
  EXPECT_FLOAT_EQ(heightAt(*field, {99, 99}), heightAt(*field, {8, 8}));
}

TEST(HeightField, NormalsStandOnASlope) {
  const auto field = heightsFrom({9, 9}, {16, 16}, [](glm::vec2 p) { return 0.75f * p.x; });
  const glm::vec3 n = normalAt(*field, {1, 1});
  EXPECT_NEAR(n.x, -0.6f, 1e-4f);
  EXPECT_NEAR(n.y, 0.8f, 1e-4f);
  EXPECT_NEAR(n.z, 0.0f, 1e-4f);
}

TEST(HeightField, RangeHoldsEveryHeightOfARectangle) {
  const auto field = heightsFrom({33, 17}, {40, 30}, hills);
  const HeightRange range = heightsOver(*field, {-3, -7}, {9, 2});
  for (float x = -3; x <= 9; x += 0.5f) {
    for (float z = -7; z <= 2; z += 0.5f) {
      EXPECT_GE(heightAt(*field, {x, z}), range.lowest - 1e-4f);
      EXPECT_LE(heightAt(*field, {x, z}), range.highest + 1e-4f);
    }
  }
  const HeightRange outside = heightsOver(*field, {100, -2}, {120, 2});
  EXPECT_LE(outside.lowest, heightAt(*field, {110, 0}));
  EXPECT_GE(outside.highest, heightAt(*field, {110, 0}));
}

TEST(HeightField, RaysMeetHillsWhereBruteForceSays) {
  const auto field = heightsFrom({41, 33}, {60, 50}, hills);
  std::mt19937 random(7);
  std::uniform_real_distribution<float> wide(-60, 60), high(-4, 40), way(-1, 1);
  int hit = 0;
  for (int n = 0; n < 400; ++n) {
    const glm::vec3 origin(wide(random), high(random), wide(random));
    const glm::vec3 direction =
        glm::normalize(glm::vec3(way(random), way(random) - 0.3f, way(random)) + glm::vec3(1e-3f));
    const auto found = hitHeights(*field, origin, direction, 150);
    const auto wanted = bruteForce(*field, origin, direction, 150);
    ASSERT_TRUE(found.has_value() || !wanted.has_value()) << "ray " << n;
    if (!found) continue;
    ++hit;
    const glm::vec3 place = origin + *found * direction;
    EXPECT_NEAR(place.y, heightAt(*field, {place.x, place.z}), 2e-3f) << "ray " << n;
    // Brute force may step over a hill's tip; it never finds one that isn't there.
    if (wanted) {
      EXPECT_LE(*found, *wanted + 1e-3f) << "ray " << n;
    }
    if (wanted && *found < *wanted - 0.02f) {
      const glm::vec3 deeper = origin + (*found + 2e-3f) * direction;
      EXPECT_LE(deeper.y, heightAt(*field, {deeper.x, deeper.z}) + 1e-3f) << "ray " << n;
    }
  }
  EXPECT_GT(hit, 200);
}

TEST(HeightField, RaysMeetCliffsAndStraightDown) {
  const auto cliff = heightsFrom({101, 3}, {100, 100}, [](glm::vec2 p) { return p.x > 0 ? 50.0f : 0.0f; });
  const auto t = hitHeights(*cliff, {-30, 20, 0}, {1, 0, 0}, 200);
  ASSERT_TRUE(t.has_value());
  EXPECT_NEAR(*t, 30.4f, 1e-3f);  // rises over the metre from x = 0 to 1
  EXPECT_NEAR(*hitHeights(*cliff, {20, 90, 3}, {0, -1, 0}, 200), 40.0f, 1e-3f);
  EXPECT_NEAR(*hitHeights(*cliff, {-900, 30, 700}, {0, -1, 0}, 200), 30.0f, 1e-3f);
  EXPECT_FALSE(hitHeights(*cliff, {20, 90, 3}, {0, 1, 0}, 200).has_value());
  EXPECT_FALSE(hitHeights(*cliff, {20, 90, 3}, {0, -1, 0}, 39).has_value()) << "beyond its reach";
}

TEST(HeightField, FollowsEditsOfItsPlaceWithoutAnotherCopy) {
  Project project;
  project.terrain = terrainOf(heightsFrom({9, 9}, {16, 16}, hills));
  TerrainSettings moved = *project.terrain;
  moved.centre = {100, 0};
  moved.height = 2.0f;
  const Result<Project> edited =
      applyEdit(project, {.label = "", .steps = {Set<TerrainSettings>{moved}}, .mergeKey = {}});
  ASSERT_TRUE(edited.ok());
  const auto& heights = edited->terrain->heights;
  ASSERT_TRUE(heights != nullptr);
  EXPECT_EQ(heights->source, project.terrain->heights->source);
  EXPECT_FLOAT_EQ(heightAt(*heights, {103, 2}), 2.0f * heightAt(*project.terrain->heights, {3, 2}));

  TerrainSettings coloured = *project.terrain;
  coloured.colour = {1, 0, 0};
  const Result<Project> again =
      applyEdit(project, {.label = "", .steps = {Set<TerrainSettings>{coloured}}, .mergeKey = {}});
  EXPECT_EQ(again->terrain->heights, project.terrain->heights) << "a colour moves no ground";

  TerrainSettings flat = *project.terrain;
  flat.kind = TerrainKind::Flat;
  EXPECT_EQ(applyEdit(project, {.label = "", .steps = {Set<TerrainSettings>{flat}}, .mergeKey = {}})->terrain->heights,
            nullptr);
}

TEST(TerrainFile, KnowsNamesThatLeaveTheProjectsFolder) {
  for (const char* inside : {"", "hills.png", "terrain/a b.glb", "a/b/..c.png"}) {
    EXPECT_EQ(assetFileProblem(inside), "") << inside;
    EXPECT_EQ(outsideReason(inside), "") << inside;
  }
  for (const char* outside : {"/etc/hills.png", "../hills.png", "a/../../b.png", "a/.."}) {
    EXPECT_EQ(assetFileProblem(outside), "") << outside;
    EXPECT_NE(outsideReason(outside), "") << outside;
  }
}

TEST(TerrainFile, IsAPath) {
  for (const char* bad : {"a\\b.png", "a//b.png", "./a.png", "a/", "/", "//a.png"}) {
    EXPECT_NE(assetFileProblem(bad), "") << bad;
    Project project;
    TerrainSettings terrain;
    terrain.kind = TerrainKind::HeightMap;
    terrain.file = bad;
    project.terrain = std::make_shared<TerrainSettings>(terrain);
    const auto problems = validate(project);
    ASSERT_EQ(problems.size(), 1u) << bad;
    EXPECT_EQ(problems[0].pointer, "/terrain/file");
  }
  Project project;
  TerrainSettings terrain;
  terrain.kind = TerrainKind::Mesh;
  project.terrain = std::make_shared<TerrainSettings>(terrain);
  ASSERT_EQ(validate(project).size(), 1u) << "uneven ground needs a file";
}

}  // namespace windloom
