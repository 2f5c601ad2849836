// Bezier grass on triangle meshes.
#include <gtest/gtest.h>

#include <limits>

#include "engine/grass/mesh_area.hpp"
#include "engine/grass/poisson_disk.hpp"
#include "engine/grass/tufts.hpp"
#include "engine/model/surface_pose.hpp"
#include "engine/model/surface_shapes.hpp"
#include "tests/unit/grass/bezier_fixture.hpp"

namespace windloom {
namespace {

using namespace testing;

/// A square in the xz plane, looking up, of cells * cells * 2 triangles.
PlantMesh sheet(float side, int cells) {
  PlantMesh mesh;
  for (int k = 0; k <= cells; ++k) {
    for (int i = 0; i <= cells; ++i)
      mesh.vertices.push_back(
          {.position = side * (glm::vec3(i, 0, k) / static_cast<float>(cells) - glm::vec3(0.5f, 0, 0.5f)),
           .normal = {0, 1, 0},
           .uv = {},
           .colour = glm::vec4(1.0f)});
  }
  const auto row = static_cast<std::uint32_t>(cells + 1);
  for (std::uint32_t k = 0; k + 1 < row; ++k) {
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      const std::uint32_t a = k * row + i;
      for (const std::uint32_t index : {a, a + row, a + 1, a + 1, a + row, a + row + 1}) mesh.indices.push_back(index);
    }
  }
  mesh.high = {0.5f * side, 0.0f, 0.5f * side};
  mesh.low = -mesh.high;
  return mesh;
}

double areaOf(const PlantMesh& mesh) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const auto at = [&](std::size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[t + i]].position); };
    area += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
  }
  return area;
}

TEST(BezierSurface, HoldsDensityTimesArea) {
  for (const SurfaceShape shape :
       {SurfaceShape::Moebius, SurfaceShape::Torus, SurfaceShape::Sphere, SurfaceShape::Hare}) {
    const BezierMeadow meadow = sceneOf(shape, 2.0f, 3000.0f).place();
    const double area = 4.0 * areaOf(makeSurfaceMesh(shape));
    EXPECT_NEAR(meadow.area, area, 1e-4 * area);
    EXPECT_NEAR(static_cast<double>(meadow.count), 3000.0 * area, 2.0 + 1e-4 * 3000.0 * area);
    EXPECT_EQ(static_cast<long long>(grown(meadow).size()), meadow.count);
    for (const BezierPatch& patch : meadow.patches) ASSERT_EQ(patch.reach.w, 0.0f);
  }
}

TEST(BezierSurface, SpreadsSingleBladesEvenlyOverATorus) {
  BezierScene scene = sceneOf(SurfaceShape::Torus, 2.0f, 8000.0f);
  scene.bezier.tufts = 0.0f;
  const auto blades = grown(scene.place());
  constexpr int kAround = 24, kTube = 14;
  std::vector<double> found(kAround * kTube, 0.0), expected(kAround * kTube, 0.0);
  const auto part = [](float angle, int count) {
    const float turn = angle / 6.2831853f;
    return std::min(static_cast<int>((turn - std::floor(turn)) * static_cast<float>(count)), count - 1);
  };
  for (const BezierBlade& blade : blades) {
    const float out = std::hypot(blade.x, blade.z) - 0.7f;
    ++found[static_cast<std::size_t>(part(std::atan2(blade.z, blade.x), kAround) * kTube +
                                     part(std::atan2(blade.y - 0.3f, out), kTube))];
  }
  double whole = 0;
  for (int v = 0; v < kTube; ++v) {
    for (int s = 0; s < 20; ++s) {
      const double weight = 0.7 + 0.3 * std::cos(6.283185307 * (v + (s + 0.5) / 20) / kTube);
      whole += weight * kAround;
      for (int u = 0; u < kAround; ++u) expected[static_cast<std::size_t>(u * kTube + v)] += weight;
    }
  }
  for (double& one : expected) one *= static_cast<double>(blades.size()) / whole;
  EXPECT_LT(chiSquareExcess(found, expected), 6.0);
  EXPECT_GT(
      chiSquareExcess(found, std::vector<double>(found.size(), static_cast<double>(blades.size()) / (kAround * kTube))),
      100.0);
}

TEST(BezierSurface, StandsAtRightAnglesOnTheSurface) {
  for (const float tufts : {0.0f, 1.0f}) {
    BezierScene scene = sceneOf(SurfaceShape::Sphere, 3.0f, 400.0f);
    scene.bezier.tufts = tufts;
    for (const BezierBlade& blade : grown(scene.place())) {
      const glm::vec3 out = rootOf(blade) - glm::vec3(0.0f, 1.5f, 0.0f);
      ASSERT_NEAR(glm::length(out), 1.5f, 0.006f) << "on the triangles of a round sphere";
      ASSERT_GT(glm::dot(glm::normalize(out), upOf(blade)), 0.999f);
      ASSERT_NEAR(glm::length(upOf(blade)), 1.0f, 1e-5f);
    }
  }
}

TEST(BezierSurface, TuftsStayOnTheTriangles) {
  BezierScene scene = sceneOf(SurfaceShape::Hare, 2.0f, 300.0f);
  scene.bezier.tufts = 1.0f;
  const auto mesh = surfaceMesh(scene.surfaces[0]);
  const glm::mat4 pose = surfacePose(scene.surfaces[0], nullptr);
  const auto blades = grown(scene.place());
  ASSERT_GT(blades.size(), 1000u);
  for (std::size_t n = 0; n < blades.size(); n += 40) {
    float nearest = 1.0f;
    for (std::size_t t = 0; t < mesh->indices.size(); t += 3) {
      const auto at = [&](std::size_t i) {
        return glm::vec3(pose * glm::vec4(mesh->vertices[mesh->indices[t + i]].position, 1.0f));
      };
      nearest = std::min(nearest, toTriangle(rootOf(blades[n]), at(0), at(1), at(2)));
    }
    ASSERT_LT(nearest, 1e-4f);
  }
}

TEST(BezierSurface, GrowsOnAllOfTheBandsOneSide) {
  BezierScene scene = sceneOf(SurfaceShape::Moebius, 4.0f, 1000.0f);
  scene.bezier.tufts = 0.0f;
  // At one place of the ring blades stand on both faces of the band.
  int one = 0, other = 0;
  glm::vec3 first(0.0f);
  for (const BezierBlade& blade : grown(scene.place())) {
    if (std::abs(std::atan2(blade.z, blade.x) - 1.0f) > 0.1f) continue;
    if (first == glm::vec3(0.0f)) first = upOf(blade);
    (glm::dot(first, upOf(blade)) > 0.0f ? one : other) += 1;
  }
  EXPECT_GT(one, 100);
  EXPECT_NEAR(one, other, 0.2 * one);
}

TEST(BezierSurface, BothSidesDoubleASheet) {
  BezierScene scene = sceneOf(sheet(4.0f, 8), 100.0f);
  scene.surfaces[0].lift = 2.0f;
  EXPECT_EQ(scene.place().count, 1600);
  scene.surfaces[0].bothSides = true;
  const BezierMeadow meadow = scene.place();
  EXPECT_EQ(meadow.count, 3200);
  EXPECT_NEAR(meadow.area, 32.0, 1e-3);
  int up = 0, down = 0;
  for (const BezierBlade& blade : grown(meadow)) {
    ASSERT_NEAR(std::abs(upOf(blade).y), 1.0f, 1e-4f);
    (upOf(blade).y > 0.0f ? up : down) += 1;
  }
  EXPECT_NEAR(up, down, 0.1 * up);
}

TEST(BezierSurface, TuftsAreAPoissonDiskOnBothSidesOfASheet) {
  ThreadPool pool;
  const auto mesh = std::make_shared<PlantMesh>(sheet(10.0f, 20));
  const MeshArea area(mesh, glm::mat4(1.0f), true, true, pool);
  const TuftField field = plantTufts(area, {{20000, 0}, 0.5f, 0.1f, 3}, pool, nullptr);
  int sides[2] = {0, 0};
  for (std::size_t i = 0; i < field.centres.size(); ++i) {
    ++sides[field.centres[i].up.y > 0.0f ? 0 : 1];
    for (std::size_t k = 0; k < i; ++k) {
      if (glm::dot(field.centres[i].up, field.centres[k].up) < 0.0f) continue;
      ASSERT_GE(glm::distance(field.centres[i].place, field.centres[k].place), 0.5f);
    }
  }
  // As many on each side as if the other weren't there.
  const MeshArea front(mesh, glm::mat4(1.0f), false, true, pool);
  const auto alone = static_cast<int>(plantTufts(front, {{20000, 0}, 0.5f, 0.1f, 3}, pool, nullptr).centres.size());
  EXPECT_GT(alone, 220);
  EXPECT_NEAR(sides[0], alone, 0.1 * alone);
  EXPECT_NEAR(sides[1], alone, 0.1 * alone);
  EXPECT_EQ(field.first.back(), 20000);
  EXPECT_EQ(field.first.size(), field.centres.size() + 1);
  // Few blades need few tufts: at least four in each.
  EXPECT_LE(plantTufts(area, {{80, 0}, 0.05f, 0.1f, 3}, pool, nullptr).centres.size(), 25u);
}

TEST(BezierSurface, WalksStraightOnOverEdges) {
  ThreadPool pool;
  // A sheet that is bent by a right angle at x = 0.
  PlantMesh bent = sheet(2.0f, 2);
  for (PlantVertex& vertex : bent.vertices) {
    if (vertex.position.x > 0.0f) vertex.position = {0.0f, -vertex.position.x, vertex.position.z};
    vertex.normal = glm::vec3(0.0f);  // the triangles' own
  }
  const MeshArea area(std::make_shared<PlantMesh>(bent), glm::mat4(1.0f), false, true, pool);
  RandomStream random(1);
  GrowthPoint from = area.at(0, 0.0, random);
  while (from.up.y < 0.5f || from.place.x < -0.4f || std::abs(from.place.z) > 0.5f)
    from = area.at(0, static_cast<double>(random.next()), random);
  const auto there = area.beside(0, from, {0.7f, 0.0f, 0.1f}, random);
  ASSERT_TRUE(there);
  EXPECT_NEAR(there->place.x, 0.0f, 1e-5f);
  EXPECT_NEAR(there->place.y, -(0.7f + from.place.x), 1e-5f);
  EXPECT_NEAR(there->place.z, from.place.z + 0.1f, 1e-5f);
  EXPECT_NEAR(there->up.x, 1.0f, 1e-5f);
  const auto border = area.beside(0, from, {-5.0f, 0.0f, 0.0f}, random);
  ASSERT_TRUE(border);
  EXPECT_NEAR(border->place.x, -1.0f, 1e-5f) << "it ends at the border";
}

TEST(BezierSurface, LivesWithDegenerateMeshes) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  const auto place = [](PlantMesh mesh) {
    BezierScene scene = sceneOf(std::move(mesh), 100.0f);
    scene.surfaces[0].tilt = 30.0f;
    const BezierMeadow meadow = scene.place();
    for (const BezierBlade& blade : meadow.blades) {
      EXPECT_TRUE(std::isfinite(blade.x) && std::isfinite(blade.y) && std::isfinite(blade.z));
      EXPECT_NEAR(glm::length(upOf(blade)), 1.0f, 1e-4f);
    }
    for (const BezierPatch& patch : meadow.patches) EXPECT_TRUE(std::isfinite(glm::dot(patch.centre, patch.reach)));
    return meadow.count;
  };
  EXPECT_EQ(place({}), 0) << "no triangles";
  PlantMesh mesh = sheet(2.0f, 4);
  for (PlantVertex& vertex : mesh.vertices) vertex.position.z = 0.0f;
  EXPECT_EQ(place(mesh), 0) << "triangles without area";
  mesh = sheet(2.0f, 4);
  mesh.indices.insert(mesh.indices.end(), {0, 0, 1, 2, 2, 2, 0, 1, 2});
  EXPECT_EQ(place(mesh), 400) << "some triangles without area";
  for (const float bad : {nan, infinite, -infinite, 1e38f}) {
    mesh = sheet(2.0f, 4);
    mesh.vertices[12].position.y = bad;  // the middle: six triangles of 32
    EXPECT_NEAR(static_cast<double>(place(mesh)), 400.0 * 26.0 / 32.0, 1.0) << bad;
  }
  for (const float bad : {nan, 0.0f, infinite}) {
    mesh = sheet(2.0f, 4);
    for (PlantVertex& vertex : mesh.vertices) vertex.normal = glm::vec3(bad);
    EXPECT_EQ(place(mesh), 400) << "normals can't be used: " << bad;
  }
  mesh = sheet(2.0f, 4);
  mesh.indices[4] = 4'000'000'000u;
  mesh.indices.push_back(1);
  EXPECT_NEAR(static_cast<double>(place(mesh)), 400.0 * 31.0 / 32.0, 1.0)
      << "indices beyond the vertices, a triangle too short";
}

TEST(BezierSurface, TakesTenMillionTriangles) {
  PlantMesh mesh = sheet(20.0f, 1000);
  const std::size_t once = mesh.indices.size();
  mesh.indices.reserve(5 * once);
  for (int i = 0; i < 4; ++i)
    mesh.indices.insert(mesh.indices.end(), mesh.indices.begin(), mesh.indices.begin() + static_cast<long>(once));
  ASSERT_EQ(mesh.indices.size() / 3, 10'000'000u);
  const BezierMeadow meadow = sceneOf(std::move(mesh), 50.0f).place();
  EXPECT_NEAR(static_cast<double>(meadow.count), 100'000.0, 100.0);
}

TEST(BezierSurface, LeavesOutWhatIsHiddenOrNotRead) {
  BezierScene scene = sceneOf(SurfaceShape::Sphere, 1.0f, 1000.0f);
  scene.surfaces[0].hidden = true;
  EXPECT_EQ(scene.place().count, 0);
  scene = sceneOf(SurfaceShape::Mesh, 1.0f, 1000.0f);
  EXPECT_EQ(scene.place().count, 0);
}

}  // namespace
}  // namespace windloom
