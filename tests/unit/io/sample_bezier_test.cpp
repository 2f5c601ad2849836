// The samples of Bezier grass hold what their READMEs say.
#include <gtest/gtest.h>

#include "engine/core/file.hpp"
#include "engine/io/project_json.hpp"
#include "engine/model/collider_motion.hpp"

namespace windloom {
namespace {

std::string pathOf(const std::string& name) {
  return WINDLOOM_PROJECTS "/" + name + "/" + name + ".wind.json";
}

Project sample(const std::string& name) {
  const auto loaded = loadProject(pathOf(name));
  EXPECT_TRUE(loaded.ok()) << loaded.error().text();
  if (!loaded) return {};
  EXPECT_TRUE(loaded->warnings.empty()) << name;
  EXPECT_TRUE(loaded->missing.empty()) << name;
  return loaded->project;
}

TEST(SampleBezier, AreWrittenAsTheEditorWritesThem) {
  for (const char* name : {"nature", "helicopter", "moebius", "fur"}) {
    const Project project = sample(name);
    EXPECT_EQ(project.grass->kind, GrassKind::Bezier) << name;
    EXPECT_EQ(project.cameras->front().name, "hero") << name;
    const Result<std::string> text = readFile(pathOf(name));
    ASSERT_TRUE(text.ok());
    EXPECT_EQ(writeProject(project), *text) << name;
  }
}

TEST(SampleBezier, NatureCollidesWithAThousandSpheresAndTwoBalls) {
  const Project project = sample("nature");
  EXPECT_EQ(project.bezier->most, 397'881);
  EXPECT_EQ(colliderPrimitives(project, 2.0).size(), 1002u);
  for (const Collider& collider : *project.colliders) {
    if (collider.shape != ColliderShape::Sphere) continue;
    ASSERT_GT(collider.keys.size(), 8u) << collider.name;
    const float seam = collider.keys.back().time;
    EXPECT_LT(
        glm::distance(colliderOffset(collider, double(seam) - 1e-3), colliderOffset(collider, double(seam) + 1e-3)),
        0.01f);
    // They keep to the meadow, and out of each other's and the tree's way.
    for (float t = 0.0f; t < seam; t += 0.05f) {
      const glm::vec3 at = colliderPose(collider, project.terrain->heights.get(), double(t)).centre;
      EXPECT_LT(std::max(std::abs(at.x), std::abs(at.z)), 0.5f * project.field->size.x) << collider.name << " at " << t;
      for (const ColliderPrimitive& part :
           colliderPrimitives(project.colliders->back(), project.terrain->heights.get(), 0.0)) {
        EXPECT_GT(glm::distance(at, glm::vec3(part.a)), collider.radius) << collider.name << " in the tree at " << t;
      }
    }
  }
}

TEST(SampleBezier, HelicopterHoversOverItsRotorsWash) {
  const Project project = sample("helicopter");
  EXPECT_EQ(project.bezier->most, 900'000);
  ASSERT_EQ(project.rotors->size(), 1u);
  ASSERT_EQ(project.colliders->size(), 1u);
  const ColliderPose pose = colliderPose(project.colliders->front(), nullptr, 0.0);
  const Rotor& rotor = project.rotors->front();
  EXPECT_NEAR(pose.centre.x, rotor.position.x, 1e-4f);
  EXPECT_NEAR(pose.centre.y + 3.05f, rotor.lift, 0.2f) << "its rotor stands 3.05 m over its skids";
}

TEST(SampleBezier, SurfacesAreTheBandAndTheHare) {
  EXPECT_EQ(sample("moebius").surfaces->front().shape, SurfaceShape::Moebius);
  EXPECT_EQ(sample("fur").surfaces->front().shape, SurfaceShape::Hare);
}

}  // namespace
}  // namespace windloom
