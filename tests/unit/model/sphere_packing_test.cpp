#include "engine/model/sphere_packing.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace windloom {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// A closed surface over a grid of two angles.
PlantMesh surface(int along, int around, const std::function<glm::vec3(float, float)>& at) {
  PlantMesh mesh;
  for (int i = 0; i <= along; ++i) {
    for (int k = 0; k <= around; ++k)
      mesh.vertices.push_back({.position = at(static_cast<float>(i) / static_cast<float>(along),
                                              static_cast<float>(k) / static_cast<float>(around))});
  }
  const auto row = static_cast<std::uint32_t>(around + 1);
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(along); ++i) {
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(around); ++k) {
      const std::uint32_t a = i * row + k;
      for (const std::uint32_t index : {a, a + 1, a + row + 1, a, a + row + 1, a + row}) mesh.indices.push_back(index);
    }
  }
  return mesh;
}

PlantMesh sphere(float radius) {
  return surface(48, 96, [=](float u, float v) {
    return radius * glm::vec3(std::sin(kPi * u) * std::cos(2 * kPi * v), std::cos(kPi * u),
                              std::sin(kPi * u) * std::sin(2 * kPi * v));
  });
}

PlantMesh torus(float ring, float tube) {
  return surface(96, 48, [=](float u, float v) {
    const float out = ring + tube * std::cos(2 * kPi * v);
    return glm::vec3(out * std::cos(2 * kPi * u), tube * std::sin(2 * kPi * v), out * std::sin(2 * kPi * u));
  });
}

PlantMesh box(glm::vec3 half) {
  PlantMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({.position = half * glm::vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)});
  mesh.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                  2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  return mesh;
}

struct Solid {
  const char* name;
  PlantMesh mesh;
  glm::vec3 half;                           // of its bounding box
  std::function<float(glm::vec3)> outside;  // signed distance, m
};

std::vector<Solid> solids() {
  return {
      {"sphere", sphere(0.5f), glm::vec3(0.5f), [](glm::vec3 p) { return glm::length(p) - 0.5f; }},
      {"box",
       box({1.0f, 0.4f, 0.6f}),
       {1.0f, 0.4f, 0.6f},
       [](glm::vec3 p) {
         const glm::vec3 q = glm::abs(p) - glm::vec3(1.0f, 0.4f, 0.6f);
         return glm::length(glm::max(q, glm::vec3(0.0f))) + std::min(0.0f, std::max({q.x, q.y, q.z}));
       }},
      {"torus",
       torus(0.8f, 0.25f),
       {1.05f, 0.25f, 1.05f},
       [](glm::vec3 p) { return glm::length(glm::vec2(glm::length(glm::vec2(p.x, p.z)) - 0.8f, p.y)) - 0.25f; }},
  };
}

TEST(SpherePacking, CoversSolidsWithoutStickingOut) {
  for (const Solid& solid : solids()) {
    SCOPED_TRACE(solid.name);
    const std::vector<glm::vec4> spheres = packSpheres(solid.mesh);
    ASSERT_FALSE(spheres.empty());
    EXPECT_LE(spheres.size(), kUsualSpheres);
    const float voxel = 2.0f * std::max({solid.half.x, solid.half.y, solid.half.z}) / 40.0f;
    for (const glm::vec4& one : spheres) {
      const float outside = solid.outside(glm::vec3(one));
      EXPECT_LT(outside, 0.0f) << "a centre lies inside";
      EXPECT_LE(outside + one.w, voxel * 1.001f) << "no sphere sticks out more than a voxel";
    }
    int inside = 0, covered = 0;
    constexpr int kSteps = 60;
    for (int x = 0; x < kSteps; ++x) {
      for (int y = 0; y < kSteps; ++y) {
        for (int z = 0; z < kSteps; ++z) {
          const glm::vec3 p = solid.half * ((glm::vec3(x, y, z) + 0.5f) * (2.0f / kSteps) - 1.0f);
          if (solid.outside(p) >= 0.0f) continue;
          ++inside;
          for (const glm::vec4& one : spheres) {
            const glm::vec3 away = p - glm::vec3(one);
            if (glm::dot(away, away) > one.w * one.w) continue;
            ++covered;
            break;
          }
        }
      }
    }
    EXPECT_GE(static_cast<float>(covered), 0.85f * static_cast<float>(inside));
  }
}

TEST(SpherePacking, CoversASheetThatEnclosesNothing) {
  const PlantMesh sheet = surface(4, 4, [](float u, float v) { return glm::vec3(u, 0.2f * u, v); });
  const std::vector<glm::vec4> spheres = packSpheres(sheet);
  ASSERT_FALSE(spheres.empty());
  for (const glm::vec4& one : spheres) EXPECT_LE(std::abs(one.y - 0.2f * one.x) + one.w, 3.0f / 40.0f);
  EXPECT_TRUE(packSpheres(PlantMesh{}).empty());
}

TEST(SpherePacking, GivesTheSameEveryTime) {
  EXPECT_EQ(packSpheres(torus(0.8f, 0.25f)), packSpheres(torus(0.8f, 0.25f)));
}

TEST(SpherePacking, GivesAsManyAsAskedForAndNoFewerDetails) {
  const PlantMesh ring = torus(0.8f, 0.25f);
  EXPECT_EQ(packSpheres(ring, 10).size(), 10u);
  EXPECT_EQ(packSpheres(ring, kUsualSpheres), packSpheres(ring)) << "the usual number";
  const std::vector<glm::vec4> many = packSpheres(ring, 1000);
  EXPECT_EQ(many.size(), 1000u);
  EXPECT_LT(many.back().w, packSpheres(ring).back().w) << "smaller voxels";
  for (const glm::vec4& one : many) {
    const float outside = glm::length(glm::vec2(glm::length(glm::vec2(one.x, one.z)) - 0.8f, one.y)) - 0.25f;
    EXPECT_LE(outside + one.w, 2.1f / 79.0f);
  }
  EXPECT_LE(packSpheres(ring, 5000).size(), kMaxSpheres);
}

TEST(SpherePacking, CutsAPileOfTrianglesIntoLargerVoxels) {
  PlantMesh pile;
  pile.vertices = {{.position = {0, 0, 0}}, {.position = {10, 0, 10}}, {.position = {0, 10, 10}}};
  pile.indices = {0, 1, 2, 0, 1, 2};  // an even number: nothing is behind an odd one
  const std::vector<glm::vec4> two = packSpheres(pile, kMaxSpheres);
  for (int triangle = 2; triangle < 2000; ++triangle) pile.indices.insert(pile.indices.end(), {0, 1, 2});
  const std::vector<glm::vec4> many = packSpheres(pile, kMaxSpheres);
  ASSERT_FALSE(many.empty());
  EXPECT_GT(many.front().w, 1.5f * two.front().w) << "of a sheet, as large as its voxels";
  EXPECT_LT(many.front().w, 1.0f) << "and still they lie close to it";
}

TEST(SpherePacking, CountsEveryCrossingOfWallsThatLieInEachOther) {
  PlantMesh boxes;
  for (const float half : {1.0f, 0.7f, 0.4f}) {
    const PlantMesh one = box(glm::vec3(half));
    const auto first = static_cast<std::uint32_t>(boxes.vertices.size());
    boxes.vertices.insert(boxes.vertices.end(), one.vertices.begin(), one.vertices.end());
    for (const std::uint32_t index : one.indices) boxes.indices.push_back(first + index);
  }
  const auto between = [](glm::vec3 p) {
    const float out = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return (out > 0.7f && out < 1.0f) || out < 0.4f;
  };
  for (const glm::vec4& sphere : packSpheres(boxes, kMaxSpheres))
    EXPECT_TRUE(between(glm::vec3(sphere))) << sphere.x << ' ' << sphere.y << ' ' << sphere.z;
}

TEST(SpherePacking, RepacksOnlyForAnotherNumber) {
  auto mesh = std::make_shared<PlantMesh>(torus(0.8f, 0.25f));
  mesh->spheres = packSpheres(*mesh);
  EXPECT_EQ(packedWith(mesh, 256), mesh);
  const auto packed = packedWith(mesh, 600);
  ASSERT_NE(packed, mesh);
  EXPECT_EQ(packed->spheres.size(), 600u);
  EXPECT_EQ(packedWith(packed, 600), packed);
  EXPECT_EQ(packedWith(packed, 256)->spheres, mesh->spheres);
  EXPECT_EQ(packedWith(nullptr, 600), nullptr);
}

}  // namespace
}  // namespace windloom
