// Surfaces and rotors in the editor: adding, picking, dragging, their handles and what they are told by.
#include "editor/core/surface_shape.hpp"

#include "editor/core/grips.hpp"
#include "editor/core/inspector.hpp"
#include "editor/core/project_changes.hpp"
#include "editor_bench.hpp"

namespace windloom::editor {
namespace {

Id addSurface(Bench& b, glm::vec2 place, float size = 6.0f, SurfaceShape shape = SurfaceShape::Sphere) {
  Surface surface;
  surface.shape = shape;
  surface.position = place;
  surface.size = size;
  const AddResult added = addSurfaceEdit(b.project(), surface);
  EXPECT_TRUE(b.w.apply(added.edit));
  return added.id;
}

Id addRotor(Bench& b, glm::vec2 place, float radius = 5.0f) {
  Rotor rotor;
  rotor.position = place;
  rotor.radius = radius;
  const AddResult added = addRotorEdit(b.project(), rotor);
  EXPECT_TRUE(b.w.apply(added.edit));
  return added.id;
}

const Surface& surface(const Bench& b, Id id) {
  return *findSurface(b.project(), id);
}
const Rotor& rotor(const Bench& b, Id id) {
  return *findRotor(b.project(), id);
}

/// The view from the side, as an artist has it.
void lookFromTheSide(Bench& b) {
  b.w.camera.orthographic = false;
  b.w.camera.target = {0, 0, 0};
  b.w.camera.yaw = 0;
  b.w.camera.pitch = 10;
  b.w.camera.distance = 40;
}

}  // namespace

TEST(Surfaces, EachActionAddsItsShapeInTheMiddleOfTheView) {
  Bench b;
  b.w.camera.target = {12, 0, -7};
  const std::pair<const char*, SurfaceShape> expected[] = {{"add.moebius", SurfaceShape::Moebius},
                                                           {"add.torus", SurfaceShape::Torus},
                                                           {"add.sphere", SurfaceShape::Sphere},
                                                           {"add.hare", SurfaceShape::Hare}};
  for (const auto& [action, shape] : expected) {
    EXPECT_TRUE(b.w.actions.run(action));
    const Surface* added = findSurface(b.project(), b.w.selection.active());
    ASSERT_NE(added, nullptr) << action;
    EXPECT_EQ(added->shape, shape);
  }
  expectNear(b.project().surfaces->front().position, {12, -7}, 0.01f);
  EXPECT_GT(glm::distance(b.project().surfaces->back().position, glm::vec2(12, -7)), 1.0f) << "beside the others";
  EXPECT_NE(b.w.message().text.find("keys 2 and 3"), std::string::npos) << "nothing grows on it yet: " << b.w.message().text;
  EXPECT_EQ(b.steps(), 4u);
}

TEST(Surfaces, ThereAreAtMostSixtyFourAndSixteenRotors) {
  Bench b;
  for (int i = 0; i < 65; ++i) b.w.actions.run("add.sphere");
  EXPECT_EQ(b.project().surfaces->size(), 64u);
  EXPECT_NE(b.w.message().text.find("at most 64"), std::string::npos) << b.w.message().text;
  for (int i = 0; i < 17; ++i) b.w.actions.run("add.rotor");
  EXPECT_EQ(b.project().rotors->size(), 16u);
  EXPECT_NE(b.w.message().text.find("at most 16"), std::string::npos) << b.w.message().text;
}

TEST(Surfaces, AreSelectedAndDraggedAsOneStep) {
  Bench b;
  const Id ball = addSurface(b, {5, 5});
  b.click({40, 40});
  EXPECT_TRUE(b.w.selection.empty());
  b.click({6.5f, 6});
  EXPECT_EQ(b.w.selection.active(), ball) << "inside its outline";
  const std::size_t before = b.steps();
  b.drag({5, 5}, {-10, 8});
  expectNear(surface(b, ball).position, {-10, 8}, 0.01f);
  EXPECT_EQ(b.steps(), before + 1);
  b.key("Ctrl+Z");
  expectNear(surface(b, ball).position, {5, 5});
  b.drag({5, 5}, {20, 5}, kAlt);
  ASSERT_EQ(b.project().surfaces->size(), 2u) << "Alt+drag copies";
}

TEST(Surfaces, ABodyInTheAirIsPickedWhereItIsSeen) {
  Bench b;
  const Id ball = addSurface(b, {0, 0});
  Surface lifted = surface(b, ball);
  lifted.lift = 6;
  b.w.apply(Edit{"Lift", {Put<Surface>{lifted}}, {}});
  lookFromTheSide(b);
  const auto first = [&](glm::vec3 place) {
    const auto hits = b.w.context().hits(*b.w.view().toScreen(place));
    return hits.empty() ? 0 : hits.front().id;
  };
  EXPECT_EQ(first({0, 9, 0}), ball);
  EXPECT_EQ(first({0, 0, 0}), ball) << "its handle on the ground";
  EXPECT_EQ(first({0, 4, 0}), 0u) << "below it";
  EXPECT_EQ(first({5, 9, 0}), 0u) << "beside it";
  for (const glm::vec3 corner : cornersOf(lifted, b.w.ground)) {
    EXPECT_GE(corner.y, 6.0f - 1e-3f);
    EXPECT_LE(corner.y, 12.0f + 1e-3f);
  }
}

TEST(Surfaces, TheBoxFollowsTiltAndRotation) {
  Surface slab;
  slab.shape = SurfaceShape::Mesh;
  slab.file = "slab.glb";
  auto mesh = std::make_shared<PlantMesh>();
  mesh->file = slab.file;
  mesh->low = {-2, 0, -1};
  mesh->high = {2, 0.5f, 1};
  slab.mesh = mesh;
  slab.scale = 2;
  const auto near = [](glm::vec3 a, glm::vec3 b) { EXPECT_LT(glm::distance(a, b), 1e-4f) << a.x << a.y << a.z; };
  near(boxOf(slab).high, {4, 1, 2});
  slab.tilt = 90;
  near(boxOf(slab).high - boxOf(slab).low, {8, 4, 1});
  EXPECT_EQ(boxOf(slab).low.y, 0.0f) << "stands on its lowest point";
  slab.tilt = 0;
  slab.rotation = 90;
  EXPECT_TRUE(isInside(slab, {0, 3.9f}));
  EXPECT_FALSE(isInside(slab, {3.9f, 0}));
  EXPECT_NEAR(reachOf(slab), std::hypot(4.0f, 2.0f), 1e-4f);
}

TEST(Surfaces, LockedAndHiddenOnesAreNotPickedAndNoneIsMuted) {
  Bench b;
  const Id ball = addSurface(b, {5, 5}), blades = addRotor(b, {-20, 5});
  for (const Flag flag : {Flag::Locked, Flag::Hidden}) {
    b.w.apply(flagEdit(b.project(), std::vector<Id>{ball, blades}, flag, true));
    EXPECT_TRUE(flag == Flag::Locked ? isLocked(b.project(), ball) : isHidden(b.project(), blades));
    b.w.selection.clear();
    b.click({5, 5});
    b.click({-20, 5});
    EXPECT_TRUE(b.w.selection.empty());
    b.w.apply(clearFlagEdit(b.project(), flag));
  }
  b.click({-20, 5});
  EXPECT_EQ(b.w.selection.active(), blades);
  b.key("M");
  EXPECT_TRUE(rotor(b, blades).muted);
  b.click({5, 5});
  EXPECT_EQ(b.w.selection.active(), ball);
  b.key("M");
  EXPECT_TRUE(flagEdit(b.project(), std::vector<Id>{ball}, Flag::Muted, true).steps.empty());
}

TEST(Surfaces, TheSizeAndTheTurnHaveHandles) {
  Bench b;
  const Id ball = addSurface(b, {0, 0});
  b.click({0, 0});
  const std::vector<Grip> grips = gripsOf(b.w.context(), SelectKind::Select);
  ASSERT_EQ(grips.size(), 2u);
  EXPECT_EQ(grips[0].kind, GripKind::Radius);
  EXPECT_EQ(grips[1].kind, GripKind::Turn);
  b.drag(grips[0].place, {4.5f, 0});
  EXPECT_NEAR(surface(b, ball).size, 9.0f, 0.1f);
  b.drag(gripsOf(b.w.context(), SelectKind::Select)[1].place, {0, 12});
  EXPECT_NEAR(surface(b, ball).rotation, 90.0f, 0.5f);
  const glm::vec2 handle = gripsOf(b.w.context(), SelectKind::Select)[0].place;
  b.press(handle);
  b.move(handle + glm::vec2(1, 1));
  b.type("2.5");
  b.key("Enter");
  EXPECT_FLOAT_EQ(surface(b, ball).size, 2.5f);
}

TEST(Surfaces, TurningAndScalingTakeSurfacesAndRotorsAlong) {
  Project project;
  Surface ball;
  ball.id = 1;
  ball.position = {10, 0};
  Rotor blades;
  blades.id = 2;
  blades.position = {0, 5};
  project.surfaces = std::make_shared<std::vector<Surface>>(1, ball);
  project.rotors = std::make_shared<std::vector<Rotor>>(1, blades);
  const Project turned = *applyEdit(project, transformEdit(project, std::vector<Id>{1, 2}, {0, 0}, 90.0f, 2.0f));
  expectNear(turned.surfaces->front().position, {0, 20});
  EXPECT_FLOAT_EQ(turned.surfaces->front().size, 2.0f * ball.size);
  EXPECT_FLOAT_EQ(turned.surfaces->front().rotation, 90.0f);
  expectNear(turned.rotors->front().position, {-10, 0});
  EXPECT_FLOAT_EQ(turned.rotors->front().radius, 2.0f * blades.radius);
}

TEST(Surfaces, CopyPasteReorderAndDelete) {
  Bench b;
  const Id band = addSurface(b, {0, 0}, 6, SurfaceShape::Moebius), ball = addSurface(b, {20, 0});
  const Id blades = addRotor(b, {-20, 0});
  b.w.apply(renameEdit(b.project(), band, "band"));
  EXPECT_EQ(nameOf(b.project(), band), "band");
  EXPECT_EQ(describeIds(b.project(), std::vector<Id>{band, ball, blades}), "2 surfaces, 1 rotor");
  b.w.apply(reorderEdit(b.project(), std::vector<Id>{ball}, band));
  EXPECT_EQ(b.project().surfaces->front().id, ball);
  b.w.selection.replace({band, blades});
  b.key("Ctrl+C");
  EXPECT_NE(b.w.clipboardText().find("\"shape\": \"moebius\""), std::string::npos) << b.w.clipboardText();
  b.hover({10, 20});
  b.key("Ctrl+V");
  ASSERT_EQ(b.project().surfaces->size(), 3u);
  ASSERT_EQ(b.project().rotors->size(), 2u);
  EXPECT_EQ(b.project().surfaces->back().name, "band");
  const glm::vec2 between = b.project().surfaces->back().position - b.project().rotors->back().position;
  expectNear(between, {20, 0}, 0.01f);
  b.key("Del");
  EXPECT_EQ(b.project().surfaces->size(), 2u);
  EXPECT_EQ(b.project().rotors->size(), 1u);
}

TEST(Surfaces, BoxSelectAndFrameKnowThem) {
  Bench b;
  const Id ball = addSurface(b, {10, 10}), blades = addRotor(b, {14, 10}, 3);
  b.drag({2, 2}, {18, 16});
  EXPECT_TRUE(b.w.selection.contains(ball));
  EXPECT_TRUE(b.w.selection.contains(blades));
  EXPECT_EQ(b.w.selection.size(), 2u);
  b.key("F");
  EXPECT_NEAR(b.w.camera.target.x, 12.0f, 1.0f);
  EXPECT_NEAR(b.w.camera.target.z, 10.0f, 1.0f);
}

TEST(Rotors, ActionDragRadiusAndRing) {
  Bench b;
  EXPECT_TRUE(b.w.actions.run("add.rotor"));
  const Id id = b.w.selection.active();
  ASSERT_NE(findRotor(b.project(), id), nullptr);
  const glm::vec2 place = rotor(b, id).position;
  b.drag(place + glm::vec2(5, 0), place + glm::vec2(8, 0));
  EXPECT_NEAR(rotor(b, id).radius, 8.0f, 0.05f) << "its handle on the ground";
  b.drag(place, place + glm::vec2(-6, 4));
  expectNear(rotor(b, id).position, place + glm::vec2(-6, 4), 0.01f);
  b.key("]");
  EXPECT_GT(rotor(b, id).radius, 8.0f);
  lookFromTheSide(b);
  b.w.selection.clear();
  const auto hitsAt = [&](glm::vec3 at) { return b.w.context().hits(*b.w.view().toScreen(at)); };
  const std::vector<Hit> onRing = hitsAt(ringOf(rotor(b, id), b.w.ground)[7]);
  ASSERT_FALSE(onRing.empty());
  EXPECT_EQ(onRing.front().id, id);
  EXPECT_TRUE(onRing.front().edge);
  b.w.camera.pitch = 45;
  EXPECT_TRUE(hitsAt(hubOf(rotor(b, id), b.w.ground)).empty()) << "the air within the ring hides nothing";
}

TEST(Rotors, StandOverTheGroundWhateverTheGrassIsHigh) {
  Bench b;
  const Id id = addRotor(b, {3, 4});
  GrassSettings grass = *b.project().grass;
  grass.height = 2.0f;
  b.w.apply(Edit{"Tall", {Set<GrassSettings>{grass}}, {}});
  EXPECT_NEAR(hubOf(rotor(b, id), b.w.ground).y, rotor(b, id).lift, 1e-4f);
}

TEST(Surfaces, TheInspectorShowsWhatMattersForTheShape) {
  Bench b;
  const Id ball = addSurface(b, {0, 0});
  const auto relevant = [&](std::string_view key) {
    for (const InspectorRow& row : inspect(b.project(), {InspectorKind::Surface, {ball}}).rows)
      if (row.info.key == key) return row.relevant;
    ADD_FAILURE() << "no row " << key;
    return false;
  };
  EXPECT_TRUE(relevant("size"));
  EXPECT_FALSE(relevant("scale"));
  EXPECT_FALSE(relevant("file"));
  EXPECT_FALSE(relevant("bothSides"));
  Surface mesh = surface(b, ball);
  mesh.shape = SurfaceShape::Mesh;
  mesh.file = "rock.glb";
  b.w.apply(Edit{"Mesh", {Put<Surface>{mesh}}, {}});
  EXPECT_FALSE(relevant("size"));
  EXPECT_TRUE(relevant("scale"));
  EXPECT_TRUE(relevant("file"));
  EXPECT_TRUE(relevant("bothSides"));
  const auto sections = inspectSelection(b.project(), std::vector<Id>{ball, addRotor(b, {9, 9})});
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_EQ(sections[0].title, "Surface " + std::to_string(ball));
  EXPECT_EQ(sections[1].target.kind, InspectorKind::Rotor);
}

TEST(Surfaces, RefusalsAndChangesNameThem) {
  Bench b;
  const Id ball = addSurface(b, {0, 0});
  const Project before = b.project();
  b.w.apply(setFromText(b.project(), {InspectorKind::Surface, {ball}}, "size", "0"));
  EXPECT_NE(b.w.message().text.find("Size: found 0"), std::string::npos) << b.w.message().text;
  b.w.apply(setFromText(b.project(), {InspectorKind::Surface, {ball}}, "shape", "mesh"));
  EXPECT_NE(b.w.message().text.find("The surface's file is missing"), std::string::npos) << b.w.message().text;
  BezierSettings bezier;
  bezier.gravityDirection = {0, 0, 0};
  b.w.apply(Edit{"Gravity", {Set<BezierSettings>{bezier}}, {}});
  EXPECT_NE(b.w.message().text.find("The Bezier grass' gravity direction has no length"), std::string::npos)
      << b.w.message().text;
  b.w.apply(setFromText(b.project(), {InspectorKind::Surface, {ball}}, "size", "9"));
  b.w.apply(setFromText(b.project(), {InspectorKind::Bezier}, "tufts/share", "0.9"));
  addRotor(b, {1, 1});
  const std::vector<std::string> lines = describeChanges(before, b.project());
  const auto told = [&](const char* line) { return std::find(lines.begin(), lines.end(), line) != lines.end(); };
  EXPECT_TRUE(told("Bezier grass changed: tufts"));
  EXPECT_TRUE(told(("Surface " + std::to_string(ball) + " changed: size").c_str()));
  EXPECT_TRUE(told("1 rotor added"));
}

}  // namespace windloom::editor
