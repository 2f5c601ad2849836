// The samples with colliders move as their READMEs say.
#include <gtest/gtest.h>

#include "engine/io/project_json.hpp"
#include "engine/model/collider_motion.hpp"

namespace windloom {
namespace {

Project sample(const std::string& name) {
  const auto loaded = loadProject(WINDLOOM_PROJECTS "/" + name + "/" + name + ".wind.json");
  EXPECT_TRUE(loaded.ok()) << loaded.error().text();
  return loaded ? loaded->project : Project{};
}

TEST(SampleColliders, AFootOnTheGroundNeverSlidesAndOneAlwaysStands) {
  const Project project = sample("footsteps");
  ASSERT_EQ(project.colliders->size(), 2u);
  const double round = double(project.colliders->front().keys.back().time);
  int bothStand = 0;
  for (double t = 0.0; t < round; t += 0.005) {
    int standing = 0;
    for (const Collider& foot : *project.colliders) {
      const double before = t - 0.002, after = t + 0.002;
      if (colliderOffset(foot, before).y > 0.0f || colliderOffset(foot, after).y > 0.0f) continue;
      ++standing;
      for (const auto& [from, to] : {std::pair(before, t), std::pair(t, after)}) {
        if (from < 0.0) continue;
        const std::vector<ColliderPrimitive> a = colliderPrimitives(foot, nullptr, from),
                                             b = colliderPrimitives(foot, nullptr, to);
        EXPECT_LT(glm::distance(a[0].a, b[0].a), 1e-5f) << foot.name << " slides its heel at " << t;
        EXPECT_LT(glm::distance(a[0].b, b[0].b), 1e-5f) << foot.name << " slides its toe at " << t;
      }
    }
    EXPECT_GE(standing, 1) << "walking, not running, at " << t;
    bothStand += standing == 2 ? 1 : 0;
  }
  EXPECT_GT(bothStand, 0);
}

TEST(SampleColliders, AllComeRoundWithoutASeam) {
  for (const char* name : {"rolling-ball", "footsteps"}) {
    const Project project = sample(name);
    for (const Collider& collider : *project.colliders) {
      ASSERT_TRUE(collider.loop);
      ASSERT_GT(collider.keys.size(), 8u);
      const double seam = double(collider.keys.back().time);
      const ColliderPose before = colliderPose(collider, nullptr, seam - 1e-4),
                         after = colliderPose(collider, nullptr, seam + 1e-4);
      for (int column = 0; column < 4; ++column)
        EXPECT_LT(glm::distance(before.world[column], after.world[column]), 3e-3f) << name;
    }
  }
}

TEST(SampleColliders, TheBallKeepsItsSpeed) {
  const Project project = sample("rolling-ball");
  ASSERT_EQ(project.colliders->size(), 1u);
  const Collider& ball = project.colliders->front();
  for (double t = 0.01; t < double(ball.keys.back().time); t += 0.01) {
    EXPECT_NEAR(glm::length(colliderVelocity(ball, t)), 2.4f, 0.25f) << t;
  }
}

}  // namespace
}  // namespace windloom
