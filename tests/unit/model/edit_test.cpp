#include "engine/model/edit.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "engine/model/validate.hpp"
#include "tests/unit/model/model_fixture.hpp"

namespace windloom {
namespace {

Edit editOf(EditStep step) {
  Edit edit;
  edit.steps.push_back(std::move(step));
  return edit;
}

/// The pointers of what went wrong.
std::vector<std::string> refusals(const Project& project, const Edit& edit) {
  const Result<Project> result = applyEdit(project, edit);
  std::vector<std::string> pointers;
  if (!result) {
    for (const Problem& problem : result.error().problems) pointers.push_back(problem.pointer);
  }
  return pointers;
}

Project richProject() {
  Project project = projectOf(line());
  Obstacle rock;
  rock.id = 30;
  Probe probe;
  probe.id = 40;
  Species daisy;
  daisy.id = 50;
  daisy.shape = PlantShape::Daisy;
  Collider ball;
  ball.id = 60;
  project.species = std::make_shared<std::vector<Species>>(1, daisy);
  project.colliders = std::make_shared<std::vector<Collider>>(1, ball);
  project.obstacles = std::make_shared<std::vector<Obstacle>>(1, rock);
  project.probes = std::make_shared<std::vector<Probe>>(1, probe);
  return project;
}

}  // namespace

TEST(Edit, LeavesTheOldProjectAndOtherPartsAlone) {
  const Project before = projectOf(smallTree());
  const Result<Project> after = applyEdit(before, moveEdit(before, std::vector<Id>{2}, {0, 5}));
  ASSERT_TRUE(after.ok());
  EXPECT_EQ(findPoint(*before.graph, 2)->position, glm::vec2(10, 0));
  EXPECT_EQ(findPoint(*after->graph, 2)->position, glm::vec2(10, 5));
  EXPECT_NE(after->graph, before.graph);
  EXPECT_EQ(after->field, before.field);
  EXPECT_EQ(after->obstacles, before.obstacles);
  EXPECT_FALSE(after->sameAs(before));
}

TEST(Edit, EraseTakesArrowsAndSignalWithThePoint) {
  WindGraph graph = smallTree();
  graph.signals.resize(1);
  graph.signals[0].root = 1;
  const Project before = projectOf(graph);
  const Result<Project> after = applyEdit(before, eraseEdit({1}));
  ASSERT_TRUE(after.ok());
  EXPECT_EQ(after->graph->points.size(), 3u);
  EXPECT_EQ(after->graph->arrows.size(), 2u);
  EXPECT_TRUE(after->graph->signals.empty());
  EXPECT_TRUE(validate(*after).empty());
}

TEST(Edit, TreeAndBranchMakeValidGraphsWithFreshIds) {
  Project project;
  const TreeResult tree = treeEdit(project, {0, 0}, {10, 0}, Arrow{});
  project = applyEdit(project, tree.edit).value();
  const BranchResult branch = branchEdit(project, tree.end, {20, 5}, Arrow{});
  project = applyEdit(project, branch.edit).value();
  EXPECT_EQ(project.graph->points.size(), 3u);
  ASSERT_EQ(project.graph->arrows.size(), 2u);
  EXPECT_EQ(findArrow(*project.graph, branch.arrow)->from, tree.end);
  EXPECT_EQ(findRoots(*project.graph), (std::vector<Id>{tree.root}));
  EXPECT_TRUE(validate(project).empty());
}

TEST(Edit, RefusesWhatWouldBreakTheProject) {
  const Project before = projectOf(smallTree());
  const auto refused = [&](const EditStep& step) { return !applyEdit(before, Edit{"bad", {step}, ""}).ok(); };
  EXPECT_TRUE(refused(Put<Arrow>{arrowBetween(50, 1, 99)}));
  EXPECT_TRUE(refused(Put<Arrow>{arrowBetween(50, 1, 1)}));
  EXPECT_TRUE(refused(Put<Point>{pointAt(2, {0, 0})}));   // on top of point 1: a zero-length arrow
  EXPECT_TRUE(refused(Put<Point>{pointAt(10, {5, 5})}));  // 10 is an arrow
  FieldSettings field;
  field.resolution = {0, 1000};
  EXPECT_TRUE(refused(Set<FieldSettings>{field}));
  Obstacle obstacle;
  obstacle.id = 77;
  obstacle.radius = -1;
  EXPECT_TRUE(refused(Put<Obstacle>{obstacle}));
  EXPECT_FALSE(refused(Put<Arrow>{arrowBetween(50, 4, 3)}));
}

TEST(Edit, PutReplacesTheRecordWithTheSameId) {
  const Project before = projectOf(smallTree());
  Arrow stronger = before.graph->arrows[1];
  stronger.strength = 20;
  const Project after = applyEdit(before, Edit{"Strength", {Put<Arrow>{stronger}}, ""}).value();
  ASSERT_EQ(after.graph->arrows.size(), 3u);
  EXPECT_EQ(after.graph->arrows[1].strength, 20);
}

TEST(ApplyEdit, KeepsThePointersOfPartsThatItDoesNotTouch) {
  const Project before = richProject();
  const Result<Project> after = applyEdit(before, moveEdit(before, std::array<Id, 1>{30}, {1, 1}));
  ASSERT_TRUE(after);
  EXPECT_NE(after->obstacles, before.obstacles);
  EXPECT_EQ(after->graph, before.graph);
  EXPECT_EQ(after->probes, before.probes);
  EXPECT_EQ(after->field, before.field);
  EXPECT_EQ(after->grass, before.grass);
  EXPECT_EQ(after->extra, before.extra);
}

TEST(ApplyEdit, AnEmptyEditGivesTheSameProject) {
  const Project project = richProject();
  EXPECT_TRUE(applyEdit(project, {})->sameAs(project));
  EXPECT_TRUE(applyEdit(project, eraseEdit({999}))->sameAs(project));
}

TEST(ApplyEdit, StepsSeeWhatEarlierStepsDid) {
  const Project before = projectOf(line());
  Edit edit = eraseEdit({2});
  edit.steps.emplace_back(Put<Point>{pointAt(2, {5, 5})});
  edit.steps.emplace_back(Put<Arrow>{arrowBetween(50, 3, 2)});
  const Result<Project> after = applyEdit(before, edit);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->graph->points.size(), 3u);
  ASSERT_EQ(after->graph->arrows.size(), 1u);
  EXPECT_EQ(after->graph->arrows[0].id, 50u);
}

TEST(ApplyEdit, SignalsArePutAndErasedByRoot) {
  Signal signal;
  signal.root = 1;
  signal.kind = SignalKind::Pulse;
  const Project once = *applyEdit(projectOf(line()), editOf(Put<Signal>{signal}));
  signal.period = 9;
  const Project twice = *applyEdit(once, editOf(Put<Signal>{signal}));
  ASSERT_EQ(twice.graph->signals.size(), 1u);
  EXPECT_EQ(twice.graph->signals[0].period, 9.0f);
  EXPECT_TRUE(applyEdit(twice, editOf(EraseSignal{1}))->graph->signals.empty());
}

TEST(ApplyEdit, NamesWhatWouldNotBeValid) {
  const Project project = richProject();
  using Pointers = std::vector<std::string>;
  EXPECT_EQ(refusals(project, editOf(Put<Arrow>{arrowBetween(70, 1, 99)})), Pointers{"/graph/arrows/2/to"});
  EXPECT_EQ(refusals(project, editOf(Put<Arrow>{arrowBetween(70, 1, 2)})), Pointers{"/graph/arrows/2"});
  EXPECT_EQ(refusals(project, editOf(Put<Point>{pointAt(30, {0, 9})})), Pointers{"/obstacles/0/id"});
  EXPECT_EQ(refusals(project, moveEdit(project, std::array<Id, 1>{2}, {10, 0})), Pointers{"/graph/arrows/1"});
  Arrow weak = project.graph->arrows[0];
  weak.radius = -1;
  weak.strength = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusals(project, editOf(Put<Arrow>{weak})),
            (Pointers{"/graph/arrows/0/strength", "/graph/arrows/0/radius"}));
  GrassSettings dense;
  dense.density = 20000;
  FieldSettings large;
  large.size = {1000, 1000};
  Edit both = editOf(Set<GrassSettings>{dense});
  both.steps.emplace_back(Set<FieldSettings>{large});
  EXPECT_EQ(refusals(project, both), Pointers{"/grass/density"});
}

TEST(ApplyEdit, SpeciesAndCollidersArePutErasedAndReordered) {
  const Project before = richProject();
  Species poppy;
  poppy.id = 51;
  poppy.shape = PlantShape::Poppy;
  Collider ball = before.colliders->front();
  ball.radius = 2;
  Edit edit = editOf(Put<Species>{poppy});
  edit.steps.emplace_back(Put<Collider>{ball});
  ball.id = 61;
  edit.steps.emplace_back(Put<Collider>{ball});
  const Project both = *applyEdit(before, edit);
  ASSERT_EQ(both.species->size(), 2u);
  ASSERT_EQ(both.colliders->size(), 2u);
  EXPECT_EQ((*both.colliders)[0].radius, 2.0f);
  const Project turned = *applyEdit(both, editOf(Reorder{{51, 61}, 50}));
  EXPECT_EQ((*turned.species)[0].id, 51u);
  EXPECT_EQ(turned.colliders, both.colliders) << "its list doesn't hold the record to stand before";
  const Project turnedBack = *applyEdit(both, editOf(Reorder{{60}, 0}));
  EXPECT_EQ((*turnedBack.colliders)[1].id, 60u);
  const Project none = *applyEdit(both, eraseEdit({50, 61}));
  EXPECT_EQ(none.species->front().id, 51u);
  EXPECT_EQ(none.colliders->front().id, 60u);
  EXPECT_EQ(none.graph, both.graph);
  EXPECT_EQ(nextFreeId(both), 62u);
}

TEST(ApplyEdit, NamesWhatIsWrongWithSpeciesAndColliders) {
  const Project project = richProject();
  using Pointers = std::vector<std::string>;
  Species tuft = project.species->front();
  tuft.shape = PlantShape::Mesh;
  EXPECT_EQ(refusals(project, editOf(Put<Species>{tuft})), Pointers{"/species/0/file"});
  tuft.shape = PlantShape::Blade;
  tuft.id = 60;  // the collider's
  EXPECT_EQ(refusals(project, editOf(Put<Species>{tuft})), Pointers{"/colliders/0/id"});
  Collider ball = project.colliders->front();
  ball.keys = {{1, {}}, {1, {}}};
  EXPECT_EQ(refusals(project, editOf(Put<Collider>{ball})), Pointers{"/colliders/0/keys/1"});
}

TEST(ApplyEdit, AnotherNumberOfSpheresPacksTheMeshAgain) {
  const Project before = richProject();
  auto mesh = std::make_shared<PlantMesh>();
  mesh->file = "assets/stone.glb";
  for (int i = 0; i < 8; ++i) {
    PlantVertex corner;
    corner.position = glm::vec3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    mesh->vertices.push_back(corner);
  }
  mesh->indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                   2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
  Collider stone = before.colliders->front();
  stone.shape = ColliderShape::Mesh;
  stone.file = mesh->file;
  stone.mesh = mesh;
  stone.spheres = 20;
  const Project packed = *applyEdit(before, editOf(Put<Collider>{stone}));
  ASSERT_TRUE(packed.colliders->front().mesh);
  EXPECT_EQ(packed.colliders->front().mesh->spheres.size(), 20u);
  stone = packed.colliders->front();
  stone.lift = 1.0f;
  EXPECT_EQ(applyEdit(packed, editOf(Put<Collider>{stone}))->colliders->front().mesh, stone.mesh);
  stone.spheres = 0;
  EXPECT_FALSE(applyEdit(packed, editOf(Put<Collider>{stone})).ok()) << "1 to 1024";
}

TEST(ApplyEdit, WhatWasReadStaysOnlyWithTheNameOfItsFile) {
  const Project before = richProject();
  auto mesh = std::make_shared<PlantMesh>();
  mesh->file = "assets/tuft.glb";
  Species tuft = before.species->front();
  tuft.shape = PlantShape::Mesh;
  tuft.file = mesh->file;
  tuft.mesh = mesh;
  Collider stone = before.colliders->front();
  stone.file = mesh->file;
  stone.mesh = mesh;
  auto map = std::make_shared<GrassMap>();
  map->file = "assets/mask.png";
  GrassSettings grass;
  grass.densityMap = map->file;
  grass.densityPixels = grass.heightPixels = map;
  Edit edit = editOf(Put<Species>{tuft});
  edit.steps.emplace_back(Put<Collider>{stone});
  edit.steps.emplace_back(Set<GrassSettings>{grass});
  ShellSettings shell;
  shell.texture = map->file;
  shell.pixels = map;
  edit.steps.emplace_back(Set<ShellSettings>{shell});
  const Project read = *applyEdit(before, edit);
  EXPECT_EQ(read.species->front().mesh, mesh);
  EXPECT_EQ(read.colliders->front().mesh, mesh);
  EXPECT_EQ(read.grass->densityPixels, map);
  EXPECT_EQ(read.grass->heightPixels, nullptr) << "no height map is named";
  EXPECT_EQ(read.shell->pixels, map);
  tuft.file = "assets/other.glb";
  stone.file.clear();
  grass.densityMap = "assets/other.png";
  edit = editOf(Put<Species>{tuft});
  edit.steps.emplace_back(Put<Collider>{stone});
  edit.steps.emplace_back(Set<GrassSettings>{grass});
  shell.texture.clear();
  edit.steps.emplace_back(Set<ShellSettings>{shell});
  const Project renamed = *applyEdit(read, edit);
  EXPECT_EQ(renamed.species->front().mesh, nullptr);
  EXPECT_EQ(renamed.colliders->front().mesh, nullptr);
  EXPECT_EQ(renamed.grass->densityPixels, nullptr);
  EXPECT_EQ(renamed.shell->pixels, nullptr);
}

TEST(MoveEdit, MovesPointsObstaclesCollidersAndProbesTogether) {
  const Project before = richProject();
  const Result<Project> after = applyEdit(before, moveEdit(before, std::array<Id, 6>{3, 30, 40, 60, 11, 777}, {1, -2}));
  ASSERT_TRUE(after);
  EXPECT_EQ(after->graph->points[2].position, glm::vec2(21, -2));
  EXPECT_EQ((*after->obstacles)[0].centre, glm::vec2(1, -2));
  EXPECT_EQ((*after->probes)[0].position, glm::vec2(1, -2));
  EXPECT_EQ((*after->colliders)[0].position, glm::vec2(1, -2));
  EXPECT_EQ(after->species, before.species);
}

TEST(BranchEdit, AddsAPointAndAnArrowLikeTheModel) {
  const Project before = richProject();
  Arrow model = before.graph->arrows[0];
  model.strength = 33;
  model.name = "trunk";
  model.muted = true;
  const BranchResult branch = branchEdit(before, 2, {10, 10}, model);
  const Result<Project> after = applyEdit(before, branch.edit);
  ASSERT_TRUE(after);
  EXPECT_EQ(branch.point, 61u);
  const Arrow* added = findArrow(*after->graph, branch.arrow);
  ASSERT_NE(added, nullptr);
  EXPECT_EQ(added->from, 2u);
  EXPECT_EQ(added->to, branch.point);
  EXPECT_EQ(added->strength, 33.0f);
  EXPECT_EQ(added->name, "");
  EXPECT_FALSE(added->muted);
  EXPECT_EQ(findPoint(*after->graph, branch.point)->position, glm::vec2(10, 10));
}

TEST(Ids, TakeTheLowestFreeOnesWhereTheHighestHaveComeToTheirEnd) {
  WindGraph graph = line();
  graph.points.push_back(pointAt(kMaxId - 1, {50, 0}));
  Project project = projectOf(graph);
  EXPECT_EQ(nextFreeId(project), kMaxId);
  FreeIds ids(project);
  std::vector<Id> taken;
  for (int i = 0; i < 10; ++i) taken.push_back(ids.take());
  EXPECT_EQ(taken, (std::vector<Id>{kMaxId, 4, 5, 6, 7, 8, 9, 10, 13, 14}));

  graph.points.push_back(pointAt(kMaxId, {60, 0}));
  project = projectOf(graph);
  const BranchResult branch = branchEdit(project, kMaxId, {70, 0}, Arrow{});
  EXPECT_TRUE(applyEdit(project, branch.edit));
  EXPECT_EQ((std::vector<Id>{branch.point, branch.arrow}), (std::vector<Id>{4, 5}));
  const TreeResult tree = treeEdit(project, {0, 30}, {10, 30}, Arrow{});
  EXPECT_TRUE(applyEdit(project, tree.edit));
}

TEST(Ids, BeyondTheHighestAreRefusedAsTheNumbersTheyAre) {
  const Project project = projectOf(line());
  const Result<Project> refused = applyEdit(project, editOf(Put<Point>{pointAt(kMaxId + 1, {50, 0})}));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().text().find("found 2147483648, expected an id from 1 to 2147483647"), std::string::npos)
      << refused.error().text();
}

}  // namespace windloom
