#include "engine/grass/plant_layout.hpp"

#include <gtest/gtest.h>

namespace windloom {
namespace {

std::vector<Species> species() {
  std::vector<Species> all(3);
  all[0].id = 1;
  all[0].shape = PlantShape::Daisy;
  all[0].weight = 0.5f;
  all[1].id = 2;
  all[1].shape = PlantShape::Blade;
  all[1].weight = 0.25f;
  all[2].id = 3;
  all[2].shape = PlantShape::Mesh;
  all[2].weight = 0.25f;
  for (Species& one : all) one.patchiness = 0.0f;
  return all;
}

const PlantMeshSummary kMesh{{-0.1f, 0, -0.1f}, {0.1f, 1, 0.1f}, 100, 0.5f};

TEST(PlantLayout, SharesTheDensityByWeight) {
  GrassSettings grass;
  grass.density = 80.0f;
  EXPECT_FLOAT_EQ(ownShare(species()), 0.5f);
  EXPECT_FLOAT_EQ(plantDensity(grass, species(), 0), 20.0f);
  EXPECT_FLOAT_EQ(plantDensity(grass, species(), 2), 10.0f);
  std::vector<Species> hidden = species();
  hidden[1].hidden = true;
  EXPECT_FLOAT_EQ(plantDensity(grass, hidden, 0), 20.0f) << "hiding one leaves the others";
  grass.kind = GrassKind::None;
  EXPECT_FLOAT_EQ(plantDensity(grass, species(), 0), 0.0f);
}

TEST(PlantLayout, DrawsWhatIsThere) {
  std::vector<Species> all = species();
  EXPECT_EQ(meshSpecies({}, all), std::vector<std::size_t>{0})
      << "blades are drawn elsewhere, a mesh that isn't read not at all";
  auto mesh = std::make_shared<PlantMesh>();
  mesh->indices = {0, 0, 0};
  all[2].mesh = mesh;
  EXPECT_EQ(meshSpecies({}, all), (std::vector<std::size_t>{0, 2}));
  all[0].hidden = true;
  EXPECT_EQ(meshSpecies({}, all), std::vector<std::size_t>{2});
  EXPECT_EQ(meshSpecies({}, std::vector<Species>(40, all[2])).size(), std::size_t{PLANT_KINDS});
}

TEST(PlantLayout, CellsHoldTheDensity) {
  for (const float density : {0.5f, 20.0f, 300.0f}) {
    GrassSettings grass;
    grass.density = density;
    const PlantKind kind = makePlantKind(grass, species(), 0, kMesh);
    EXPECT_NEAR(kind.growth.x / (kind.growth.w * kind.growth.w), plantDensity(grass, species(), 0), 1e-3f * density);
  }
}

TEST(PlantLayout, PatchesKeepTheNumberOfPlants) {
  std::vector<Species> patchy = species();
  patchy[0].patchiness = 1.0f;
  const PlantKind even = makePlantKind({}, species(), 0, kMesh), gathered = makePlantKind({}, patchy, 0, kMesh);
  const auto perArea = [](const PlantKind& kind) { return kind.growth.x / (kind.growth.w * kind.growth.w); };
  EXPECT_GT(perArea(gathered), 2.0f * perArea(even)) << "more candidates, of which patches keep a part";
}

TEST(PlantLayout, ReachFollowsTheCameraOnTheSameCells) {
  const PlantKind kind = makePlantKind({}, species(), 0, kMesh);
  FieldSettings field;
  field.size = {4000.0f, 4000.0f};
  PlantView view;
  view.pixelScale = 800.0f;
  const PlantCells here = cellsInReach(kind, field, view);
  EXPECT_GT(here.count.x, 0);
  EXPECT_LT(static_cast<float>(here.count.x) * kind.growth.w, 2500.0f) << "not all of a large field";
  view.eye = {10.0f * kind.growth.w, 0, 0};
  const PlantCells there = cellsInReach(kind, field, view);
  EXPECT_EQ(there.first.x, here.first.x + 10);
  view.eye = {9000.0f, 0, 0};
  EXPECT_EQ(cellsInReach(kind, field, view).count, glm::ivec2(0));
  view.orthographic = true;
  EXPECT_GE(static_cast<float>(cellsInReach(kind, field, view).count.x) * kind.growth.w, 4000.0f);
}

}  // namespace
}  // namespace windloom
