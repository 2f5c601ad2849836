#include "editor/core/camera_control.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "editor/core/navigation.hpp"
#include "editor_bench.hpp"
#include "tests/height_fixture.hpp"

namespace windloom::editor {
namespace {
constexpr glm::vec2 kView{1280.0f, 720.0f};
const Ground kFlat;
}  // namespace

TEST(CameraControl, TargetIsTheMiddleOfTheView) {
  for (const bool orthographic : {false, true}) {
    EditorCamera camera;
    camera.target = {3, 0, -7};
    camera.orthographic = orthographic;
    const ViewMapping view(camera, kView);
    const auto pixel = view.toScreen(camera.target);
    ASSERT_TRUE(pixel);
    expectNear(*pixel, 0.5f * kView, 0.01f);
    expectNear(*view.toGround(0.5f * kView, kFlat), {3, -7}, 0.01f);
  }
}

TEST(CameraControl, GroundAndScreenAreInverse) {
  for (const bool orthographic : {false, true}) {
    EditorCamera camera;
    camera.yaw = -70.0f;
    camera.orthographic = orthographic;
    const ViewMapping view(camera, kView);
    for (const glm::vec2 place : {glm::vec2(0, 0), glm::vec2(12, -9), glm::vec2(-20, 14)}) {
      const auto pixel = view.groundToScreen(place, kFlat);
      ASSERT_TRUE(pixel);
      expectNear(*view.toGround(*pixel, kFlat), place, 0.01f);
    }
  }
}

TEST(CameraControl, PoseAndMappingAgreeOnTheUpperEdge) {
  // What the renderer shows at the top of the picture is tan(fov / 2) above the middle.
  EditorCamera camera;
  const CameraPose pose = camera.pose();
  const glm::vec3 above = camera.target + pose.up * camera.distance * std::tan(glm::radians(0.5f * pose.fieldOfView));
  EXPECT_NEAR(ViewMapping(camera, kView).toScreen(above)->y, 0.0f, 0.05f);
  camera.orthographic = true;
  EXPECT_NEAR(ViewMapping(camera, kView).toScreen(camera.target + camera.up() * 0.5f * pose.orthographicHeight)->y,
              0.0f, 0.05f);
}

TEST(CameraControl, TopViewHasXRightAndZDown) {
  const EditorCamera camera = lookAlong(EditorCamera{}, ViewDirection::Top);
  const ViewMapping view(camera, kView);
  EXPECT_TRUE(camera.orthographic);
  EXPECT_GT(view.toScreen({10, 0, 0})->x, 0.5f * kView.x);
  EXPECT_GT(view.toScreen({0, 0, 10})->y, 0.5f * kView.y);
}

TEST(CameraControl, PlacesBehindTheCameraAreNotOnTheScreen) {
  EditorCamera camera;
  EXPECT_FALSE(ViewMapping(camera, kView).toScreen(camera.position() - 5.0f * camera.forward()));
}

TEST(CameraControl, SkyHasNoGround) {
  EditorCamera camera;
  camera.pitch = 5.0f;
  EXPECT_FALSE(ViewMapping(camera, kView).toGround({640, 0}, kFlat));
}

TEST(CameraControl, ZoomKeepsTheGroundUnderThePointer) {
  for (const bool orthographic : {false, true}) {
    EditorCamera camera;
    camera.orthographic = orthographic;
    const glm::vec2 pixel(900, 500);
    const glm::vec2 before = *ViewMapping(camera, kView).toGround(pixel, kFlat);
    for (const float notches : {3.0f, -2.0f}) {
      const EditorCamera zoomed = zoomTo(camera, notches, pixel, kView, kFlat);
      EXPECT_EQ(zoomed.distance<camera.distance, notches> 0);
      expectNear(*ViewMapping(zoomed, kView).toGround(pixel, kFlat), before, 0.02f);
    }
  }
}

TEST(CameraControl, ZoomStaysInRangeAndFinite) {
  EditorCamera camera;
  for (int i = 0; i < 200; ++i) camera = zoomTo(camera, 5.0f, {640, 10}, kView, kFlat);
  EXPECT_GE(camera.distance, 0.5f);
  for (int i = 0; i < 200; ++i) camera = zoomTo(camera, -5.0f, {640, 10}, kView, kFlat);
  EXPECT_LE(camera.distance, 3000.0f);
  EXPECT_TRUE(std::isfinite(camera.target.x) && std::isfinite(camera.target.y) && std::isfinite(camera.target.z));
}

TEST(CameraControl, PanMovesTheSceneWithThePointer) {
  EditorCamera camera;
  camera.orthographic = true;
  const glm::vec2 place(4, 3), delta(60, -25);
  const glm::vec2 before = *ViewMapping(camera, kView).groundToScreen(place, kFlat);
  const EditorCamera panned = pan(camera, delta, kView);
  expectNear(*ViewMapping(panned, kView).groundToScreen(place, kFlat), before + delta, 0.05f);
}

TEST(CameraControl, LookAroundKeepsTheStandpoint) {
  const EditorCamera camera;
  const EditorCamera turned = lookAround(camera, {100, -40});
  EXPECT_LT(glm::distance(camera.position(), turned.position()), 1e-3f);
  EXPECT_NE(camera.yaw, turned.yaw);
}

TEST(CameraControl, FrameShowsTheWholeBox) {
  for (const bool orthographic : {false, true}) {
    EditorCamera camera;
    camera.orthographic = orthographic;
    const glm::vec2 low(40, -10), high(70, 30);
    const ViewMapping view(frameBounds(camera, low, high, kView), kView);
    for (const glm::vec2 corner : {low, high, glm::vec2(low.x, high.y), glm::vec2(high.x, low.y)}) {
      const auto pixel = view.groundToScreen(corner, kFlat);
      ASSERT_TRUE(pixel);
      EXPECT_TRUE(pixel->x > 0 && pixel->x < kView.x && pixel->y > 0 && pixel->y < kView.y);
    }
  }
}

TEST(Ground, RayMeetsAHill) {
  Ground hill;
  hill.height = windloom::testing::heightsFrom(
      {201, 201}, {100, 100}, [](glm::vec2 place) { return 10.0f * std::exp(-glm::dot(place, place) / 200.0f); });
  const Ray ray{{0, 30, 40}, glm::normalize(glm::vec3(0, -0.6f, -1))};
  const auto place = hitGround(ray, hill);
  ASSERT_TRUE(place);
  const float t = (40.0f - place->y) / -ray.direction.z;
  EXPECT_NEAR(ray.origin.y + t * ray.direction.y, hill.at(*place), 0.05f);
  EXPECT_GT(hill.at(*place), 1.0f);
}

TEST(Navigator, ButtonsAndModifiersChooseTheGesture) {
  const auto run = [](PointerButton button, Modifiers held) {
    EditorCamera camera;
    const EditorCamera before = camera;
    Navigator navigator;
    PointerEvent pointer{{400, 300}, held, button};
    if (!navigator.press(pointer)) return std::string("none");
    pointer.pixel += glm::vec2(50, 20);
    navigator.move(camera, pointer, kView, kFlat);
    EXPECT_TRUE(navigator.release(pointer));
    EXPECT_FALSE(navigator.active());
    if (camera.distance != before.distance) return std::string("zoom");
    if (camera.yaw == before.yaw) return std::string("pan");
    return std::string(camera.target == before.target ? "orbit" : "look");
  };
  EXPECT_EQ(run(PointerButton::Middle, {}), "orbit");
  EXPECT_EQ(run(PointerButton::Left, kAlt), "orbit");
  EXPECT_EQ(run(PointerButton::Middle, kShift), "pan");
  EXPECT_EQ(run(PointerButton::Middle, kAlt), "pan");
  EXPECT_EQ(run(PointerButton::Right, kAlt), "zoom");
  EXPECT_EQ(run(PointerButton::Right, {}), "look");
  EXPECT_EQ(run(PointerButton::Left, {}), "none");
  EXPECT_EQ(run(PointerButton::Left, kShift), "none");
}

TEST(Navigator, FlyingTakesKeysAndTheWheelSetsTheSpeed) {
  Bench b;
  b.w.camera = EditorCamera{};
  EXPECT_EQ(b.w.tools.active().id(), "select");
  PointerEvent right = b.at({0, 0});
  right.button = PointerButton::Right;
  b.w.pointerPressed(right);
  EXPECT_TRUE(b.w.keyPressed({Key::W, {}, false}));
  EXPECT_EQ(b.w.tools.active().id(), "select");  // W flies, it is not the move tool now
  const glm::vec3 before = b.w.camera.position();
  b.w.tick(0.05, {});
  const glm::vec3 way = b.w.camera.position() - before;
  EXPECT_NEAR(glm::length(way), 0.05f * b.w.navigator.speedMps(), 1e-3f);
  EXPECT_GT(glm::dot(way, b.w.camera.forward()), 0.0f);
  const float speed = b.w.navigator.speedMps(), distance = b.w.camera.distance;
  b.w.wheel(1.0f, right);
  EXPECT_GT(b.w.navigator.speedMps(), speed);
  EXPECT_FLOAT_EQ(b.w.camera.distance, distance);
  b.w.keyReleased(Key::W);
  const glm::vec3 stopped = b.w.camera.position();
  b.w.tick(0.05, {});
  EXPECT_EQ(b.w.camera.position(), stopped);
  b.w.pointerReleased(right);
  b.key("W");
  EXPECT_EQ(b.w.tools.active().id(), "move");
}

}  // namespace windloom::editor
