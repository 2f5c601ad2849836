#include "engine/render/frame_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "engine/render/framing.hpp"

namespace windloom {
namespace {

FrameBlock blockOf(const Project& project, const ViewCamera& camera) {
  FrameInput input;
  input.project = &project;
  input.camera = camera;
  return makeFrameBlock(input, defaultLight());
}

bool inside(const FrameBlock& block, glm::vec3 point) {
  for (const glm::vec4& plane : block.frustum) {
    if (glm::dot(glm::vec3(plane), point) + plane.w < 0.0f) return false;
  }
  return true;
}

TEST(FrameBlock, FrustumHoldsWhatTheCameraSees) {
  const Project project;
  ViewCamera camera;
  camera.position = {0.0f, 2.0f, 10.0f};
  camera.target = {0.0f, 2.0f, 0.0f};
  const FrameBlock block = blockOf(project, camera);
  EXPECT_TRUE(inside(block, {0.0f, 2.0f, 0.0f}));
  EXPECT_TRUE(inside(block, {3.0f, 3.0f, 0.0f}));
  EXPECT_FALSE(inside(block, {0.0f, 2.0f, 11.0f})) << "behind the camera";
  EXPECT_FALSE(inside(block, {30.0f, 2.0f, 0.0f})) << "beside the picture";
}

TEST(FrameBlock, KnowsHowManyPixelsAMetreCovers) {
  const Project project;
  ViewCamera camera;
  camera.orthographic = true;
  camera.orthographicHeight = 72.0f;
  EXPECT_FLOAT_EQ(blockOf(project, camera).pixelScale.x, 10.0f);
  camera.orthographic = false;
  camera.fieldOfView = 90.0f;
  EXPECT_NEAR(blockOf(project, camera).pixelScale.x, 360.0f, 1e-2f);
}

TEST(FrameBlock, HazeLetsAFieldOfKilometresBeSeen) {
  Project project;
  const float usual = blockOf(project, {}).pixelScale.y;
  EXPECT_FLOAT_EQ(usual, defaultLight().haze);
  FieldSettings field;
  field.size = {300.0f, 2000.0f};
  project.field = std::make_shared<const FieldSettings>(field);
  const float across = std::exp(-2000.0f * blockOf(project, {}).pixelScale.y);
  EXPECT_GT(across, 0.5f) << "less than half of the light comes through";
  EXPECT_LT(across, 0.9f) << "no haze at all";
}

TEST(ViewCamera, LooksStraightDownWithNorthUp) {
  const ViewCamera camera = frameFieldFromAbove({});
  const glm::mat4 matrix = camera.projection(16.0f / 9.0f) * camera.view();
  const glm::vec4 north = matrix * glm::vec4(0.0f, 0.0f, -20.0f, 1.0f),
                  east = matrix * glm::vec4(20.0f, 0.0f, 0.0f, 1.0f);
  EXPECT_GT(north.y / north.w, 0.1f);
  EXPECT_GT(east.x / east.w, 0.1f);
}

TEST(Framing, ShowsTheWholeField) {
  for (const glm::vec2 size : {glm::vec2(100.0f), glm::vec2(40.0f, 160.0f), glm::vec2(400.0f, 60.0f)}) {
    FieldSettings field;
    field.centre = {12.0f, -5.0f};
    field.size = size;
    for (const ViewCamera& camera : {frameField(field), frameFieldFromAbove(field)}) {
      const glm::mat4 matrix = camera.projection(16.0f / 9.0f) * camera.view();
      for (const glm::vec2 corner :
           {glm::vec2(-0.5f, -0.5f), glm::vec2(0.5f, -0.5f), glm::vec2(-0.5f, 0.5f), glm::vec2(0.5f, 0.5f)}) {
        const glm::vec2 at = field.centre + corner * size;
        const glm::vec4 clip = matrix * glm::vec4(at.x, 0.0f, at.y, 1.0f);
        EXPECT_GT(clip.w, 0.0f);
        EXPECT_LE(std::abs(clip.x / clip.w), 1.02f) << size.x << " x " << size.y;
        EXPECT_LE(std::abs(clip.y / clip.w), 1.02f) << size.x << " x " << size.y;
      }
    }
  }
}

}  // namespace
}  // namespace windloom
