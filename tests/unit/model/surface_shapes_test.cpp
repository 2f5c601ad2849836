#include "engine/model/surface_shapes.hpp"

#include <gtest/gtest.h>

#include <map>
#include <thread>

#include "engine/model/surface_pose.hpp"
#include "tests/height_fixture.hpp"

namespace windloom {
namespace {

constexpr SurfaceShape kBuiltIn[] = {SurfaceShape::Moebius, SurfaceShape::Torus, SurfaceShape::Sphere,
                                     SurfaceShape::Hare};

Surface surfaceOf(SurfaceShape shape, float size = 1.0f, float rotation = 0.0f, float tilt = 0.0f) {
  Surface surface;
  surface.shape = shape;
  surface.size = size;
  surface.rotation = rotation;
  surface.tilt = tilt;
  return surface;
}

/// Vertices - edges + triangles.
long euler(const PlantMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(mesh.indices[t + i], mesh.indices[t + (i + 1) % 3])];
  }
  return static_cast<long>(mesh.vertices.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(mesh.indices.size() / 3);
}

double volumeOf(const PlantMesh& mesh) {
  double volume = 0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const auto at = [&](std::size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[t + i]].position); };
    volume += glm::dot(at(0), glm::cross(at(1), at(2))) / 6.0;
  }
  return volume;
}

TEST(SurfaceShapes, AreOneMetreLongCentredAndStandOnZero) {
  for (const SurfaceShape shape : kBuiltIn) {
    const PlantMesh mesh = makeSurfaceMesh(shape);
    SCOPED_TRACE(static_cast<int>(shape));
    EXPECT_LE(mesh.indices.size() / 3, kMaxPlantTriangles);
    glm::vec3 low = mesh.vertices.front().position, high = low;
    for (const PlantVertex& vertex : mesh.vertices) {
      low = glm::min(low, vertex.position);
      high = glm::max(high, vertex.position);
    }
    EXPECT_EQ(low, mesh.low);
    EXPECT_EQ(high, mesh.high);
    const glm::vec3 size = high - low;
    EXPECT_NEAR(std::max({size.x, size.y, size.z}), 1.0f, 1e-5f);
    EXPECT_NEAR(low.x + high.x, 0.0f, 1e-5f);
    EXPECT_NEAR(low.z + high.z, 0.0f, 1e-5f);
    EXPECT_NEAR(low.y, 0.0f, 1e-6f);
  }
}

TEST(SurfaceShapes, AreClosedAndTurnTheirTrianglesOutwards) {
  for (const SurfaceShape shape : kBuiltIn) {
    SCOPED_TRACE(static_cast<int>(shape));
    const PlantMesh mesh = makeSurfaceMesh(shape);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
      for (std::size_t i = 0; i < 3; ++i) ++edges[{mesh.indices[t + i], mesh.indices[t + (i + 1) % 3]}];
    }
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1);
      ASSERT_EQ(edges.count({edge.second, edge.first}), 1u) << "every edge has a triangle on each side";
    }
    EXPECT_GT(volumeOf(mesh), 0.0) << "outside is outside";
  }
}

TEST(SurfaceShapes, HaveTheHolesThatTheyShould) {
  EXPECT_EQ(euler(makeSurfaceMesh(SurfaceShape::Sphere)), 2);
  EXPECT_EQ(euler(makeSurfaceMesh(SurfaceShape::Hare)), 2);
  EXPECT_EQ(euler(makeSurfaceMesh(SurfaceShape::Torus)), 0);
  EXPECT_EQ(euler(makeSurfaceMesh(SurfaceShape::Moebius)), 0);
}

TEST(SurfaceShapes, HaveSmoothUnitNormalsThatFitTheirTriangles) {
  for (const SurfaceShape shape : kBuiltIn) {
    SCOPED_TRACE(static_cast<int>(shape));
    const PlantMesh mesh = makeSurfaceMesh(shape);
    double area = 0, fitting = 0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
      const auto at = [&](std::size_t i) { return mesh.vertices[mesh.indices[t + i]]; };
      const glm::vec3 facing = glm::cross(at(1).position - at(0).position, at(2).position - at(0).position);
      ASSERT_GT(glm::length(facing), 0.0f) << "no triangle without area";
      for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR(glm::length(at(i).normal), 1.0f, 1e-4f);
      const float along = glm::dot(glm::normalize(facing), glm::normalize(at(0).normal + at(1).normal + at(2).normal));
      ASSERT_GT(along, 0.0f);
      area += static_cast<double>(glm::length(facing));
      fitting += static_cast<double>(glm::length(facing) * along);
    }
    EXPECT_GT(fitting / area, 0.985);
  }
}

TEST(SurfaceShapes, TheBandTurnsHalfARoundAndIsThin) {
  const PlantMesh band = makeSurfaceMesh(SurfaceShape::Moebius);
  double area = 0;
  for (std::size_t t = 0; t < band.indices.size(); t += 3) {
    const auto at = [&](std::size_t i) { return glm::dvec3(band.vertices[band.indices[t + i]].position); };
    area += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
  }
  EXPECT_LT(volumeOf(band) / area, 0.015) << "two sides back to back";
  EXPECT_GT(area, 1.0);
}

TEST(SurfaceShapes, TheHareHasTwoEarsAndLooksAlongX) {
  const PlantMesh hare = makeSurfaceMesh(SurfaceShape::Hare);
  int left = 0, right = 0;
  float ears = 0, nose = -1;
  for (const PlantVertex& vertex : hare.vertices) {
    const glm::vec3 p = vertex.position;
    if (p.y > 0.8f) {
      (p.z > 0 ? left : right) += 1;
      ears = std::max(ears, p.x);
      EXPECT_GT(std::abs(p.z), 0.01f) << "the ears stand apart";
    } else if (p.y > 0.5f) {
      nose = std::max(nose, p.x);
    }
  }
  EXPECT_GT(left, 100);
  EXPECT_NEAR(left, right, 0.05 * left);
  EXPECT_GT(nose, ears + 0.1f);
}

TEST(SurfaceShapes, AreMadeOnceForAllThreads) {
  std::vector<std::shared_ptr<const PlantMesh>> seen(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < seen.size(); ++i)
    threads.emplace_back([&seen, i] { seen[i] = surfaceMesh(surfaceOf(SurfaceShape::Hare)); });
  for (std::thread& thread : threads) thread.join();
  ASSERT_NE(seen[0], nullptr);
  for (const auto& mesh : seen) EXPECT_EQ(mesh, seen[0]);
  Surface read = surfaceOf(SurfaceShape::Mesh);
  EXPECT_EQ(surfaceMesh(read), nullptr);
  read.mesh = std::make_shared<PlantMesh>();
  EXPECT_EQ(surfaceMesh(read), read.mesh);
}

float lowestIn(const PlantMesh& mesh, const glm::mat4& pose) {
  float low = 1e9f;
  for (const PlantVertex& vertex : mesh.vertices) low = std::min(low, (pose * glm::vec4(vertex.position, 1.0f)).y);
  return low;
}

TEST(SurfacePose, StandsTheLowestPointOverTheGround) {
  const auto ground = testing::heightsFrom({65, 65}, {100, 100}, [](glm::vec2 at) { return 3.0f + 0.1f * at.x; });
  for (const SurfaceShape shape : kBuiltIn) {
    for (const float tilt : {0.0f, 35.0f, -90.0f, 180.0f}) {
      Surface surface = surfaceOf(shape, 3.0f, 50.0f, tilt);
      surface.position = {12.0f, -7.0f};
      surface.lift = 0.4f;
      const glm::mat4 pose = surfacePose(surface, ground.get());
      EXPECT_NEAR(lowestIn(*surfaceMesh(surface), pose), heightAt(*ground, {12, -7}) + 0.4f, 2e-3f);
      EXPECT_NEAR(pose[3].x, 12.0f, 1e-5f);
      EXPECT_NEAR(pose[3].z, -7.0f, 1e-5f);
      EXPECT_NEAR(glm::length(glm::vec3(pose[0])), 3.0f, 1e-4f);
    }
  }
}

TEST(SurfacePose, TurnsFromXTowardsZAndTiltsAboutItsOwnX) {
  const Surface turned = surfaceOf(SurfaceShape::Hare, 1.0f, 90.0f);
  const glm::vec3 nose = glm::vec3(surfacePose(turned, nullptr) * glm::vec4(1, 0, 0, 0));
  EXPECT_NEAR(nose.z, 1.0f, 1e-5f);
  const Surface tilted = surfaceOf(SurfaceShape::Hare, 1.0f, 90.0f, 90.0f);
  const glm::mat4 pose = surfacePose(tilted, nullptr);
  EXPECT_NEAR(glm::vec3(pose[0]).z, 1.0f, 1e-5f) << "its x axis stays level";
  EXPECT_NEAR(glm::vec3(pose[2]).y, -1.0f, 1e-5f);
}

TEST(SurfacePose, TakesScaleForFilesAndLivesWithoutAMesh) {
  Surface surface = surfaceOf(SurfaceShape::Mesh, 9.0f, 0.0f, 10.0f);
  surface.lift = 2.0f;
  surface.file = "a.glb";
  surface.scale = 0.5f;
  EXPECT_NEAR(surfacePose(surface, nullptr)[3].y, 2.0f, 1e-6f);
  EXPECT_FLOAT_EQ(surfaceScale(surface), 0.5f);
  PlantMesh broken;
  broken.vertices.resize(3);
  broken.vertices[0].position.y = std::numeric_limits<float>::quiet_NaN();
  broken.vertices[1].position = glm::vec3(1.0f, -2.0f, 0.0f);
  broken.indices = {0, 1, 2};
  surface.mesh = std::make_shared<PlantMesh>(broken);
  EXPECT_TRUE(std::isfinite(surfacePose(surface, nullptr)[3].y));
}

}  // namespace
}  // namespace windloom
