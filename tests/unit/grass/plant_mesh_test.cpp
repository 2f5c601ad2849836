#include <gtest/gtest.h>

#include <cmath>

#include "engine/grass/flower_mesh.hpp"
#include "engine/grass/mesh_simplify.hpp"
#include "engine/grass/plant_texture_mips.hpp"

namespace windloom {
namespace {

Species flower(PlantShape shape) {
  Species species;
  species.shape = shape;
  species.height = 0.6f;
  species.width = 0.006f;
  species.tipColour = {0.8f, 0.1f, 0.1f};
  return species;
}

void expectSound(const PlantMesh& mesh) {
  for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
  for (const PlantVertex& vertex : mesh.vertices) {
    EXPECT_NEAR(glm::length(vertex.normal), 1.0f, 1e-4f);
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(vertex.position, mesh.low - 1e-5f)));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(vertex.position, mesh.high + 1e-5f)));
  }
}

/// Mean height of what is petal, by area.
glm::vec3 petalMiddle(const PlantMesh& mesh) {
  glm::vec3 sum(0.0f);
  float all = 0.0f;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const PlantVertex &a = mesh.vertices[mesh.indices[t]], &b = mesh.vertices[mesh.indices[t + 1]],
                      &c = mesh.vertices[mesh.indices[t + 2]];
    const float petal =
        (a.uv.x + b.uv.x + c.uv.x) / 3.0f * glm::length(glm::cross(b.position - a.position, c.position - a.position));
    sum += petal * (a.position + b.position + c.position) / 3.0f;
    all += petal;
  }
  return sum / all;
}

TEST(FlowerMesh, HasTheTrianglesItPromises) {
  for (const PlantShape shape : {PlantShape::Daisy, PlantShape::Poppy, PlantShape::Spike}) {
    SCOPED_TRACE(static_cast<int>(shape));
    const FlowerMesh made = makeFlower(flower(shape));
    EXPECT_GE(made.near.indices.size() / 3, 60u);
    EXPECT_LE(made.near.indices.size() / 3, 200u);
    EXPECT_GE(made.far.indices.size() / 3, 6u);
    EXPECT_LE(made.far.indices.size() / 3, 20u);
    expectSound(made.near);
    expectSound(made.far);
    EXPECT_NEAR(made.near.high.y, 1.0f, 0.06f) << "one unit high";
    EXPECT_NEAR(made.near.low.y, 0.0f, 0.03f) << "stands on its root";
    EXPECT_NEAR(glm::length(petalMiddle(made.near) - petalMiddle(made.far)), 0.0f, 0.1f)
        << "its petals stay in place far away";
  }
}

TEST(FlowerMesh, TakesItsPetalsFromTheSpecies) {
  Species blue = flower(PlantShape::Daisy);
  blue.tipColour = {0.0f, 0.0f, 0.9f};
  float blueness = 0.0f;
  for (const PlantVertex& vertex : makeFlower(blue).near.vertices) blueness = std::max(blueness, vertex.colour.b);
  EXPECT_GT(blueness, 0.8f);
}

/// Many separate squares on end.
PlantMesh cards(int count) {
  PlantMesh mesh;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 foot(0.1f * static_cast<float>(i % 10), 0.05f * static_cast<float>(i / 10),
                         0.03f * static_cast<float>(i % 7));
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const glm::vec3 corner :
         {glm::vec3(0), glm::vec3(0.04f, 0, 0), glm::vec3(0.04f, 0.04f, 0), glm::vec3(0, 0.04f, 0)})
      mesh.vertices.push_back({.position = foot + corner});
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
  }
  mesh.low = glm::vec3(0);
  mesh.high = {1, 2, 1};
  return mesh;
}

float areaOf(const PlantMesh& mesh) {
  float area = 0.0f;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const glm::vec3 a = mesh.vertices[mesh.indices[t]].position;
    area += 0.5f * glm::length(glm::cross(mesh.vertices[mesh.indices[t + 1]].position - a,
                                          mesh.vertices[mesh.indices[t + 2]].position - a));
  }
  return area;
}

TEST(SimplifiedMesh, KeepsAFewLargerPieces) {
  const PlantMesh mesh = cards(100), few = simplified(mesh, 64);
  EXPECT_LE(few.indices.size() / 3, 64u);
  EXPECT_GE(few.indices.size() / 3, 50u);
  EXPECT_NEAR(areaOf(few) / areaOf(mesh), 1.0f, 0.15f);
  EXPECT_EQ(few.high, mesh.high);
}

TEST(SimplifiedMesh, LeavesSmallMeshesAlone) {
  const PlantMesh mesh = cards(10);
  EXPECT_EQ(simplified(mesh, 64).indices, mesh.indices);
}

TEST(SimplifiedMesh, MergesAWholePiece) {
  PlantMesh sheet;
  constexpr std::uint32_t kSide = 40;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i)
    sheet.vertices.push_back(
        {.position = {0.05f * static_cast<float>(i % kSide), 0.05f * static_cast<float>(i / kSide), 0}});
  for (std::uint32_t i = 0; i + kSide + 1 < kSide * kSide; ++i) {
    if (i % kSide == kSide - 1) continue;
    for (const std::uint32_t k : {i, i + 1, i + kSide + 1, i, i + kSide + 1, i + kSide}) sheet.indices.push_back(k);
  }
  sheet.high = {1.95f, 1.95f, 0};
  const PlantMesh few = simplified(sheet, 64);
  EXPECT_LE(few.indices.size() / 3, 64u);
  EXPECT_GT(areaOf(few), 0.6f * areaOf(sheet));
}

TEST(PlantTextureMips, KeepTheirCoverage) {
  PlantMesh mesh;
  mesh.textureSize = {64, 64};
  mesh.alphaCutoff = 0.5f;
  // Thin lines: plain averaging would lose them by the third level.
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool line =
          std::abs(std::sin(0.31f * static_cast<float>(x) + 2.0f * std::sin(0.13f * static_cast<float>(y)))) < 0.25f;
      mesh.texture.insert(mesh.texture.end(), {40, 160, 30, static_cast<std::uint8_t>(line ? 255 : 0)});
    }
  }
  const std::vector<MipLevel> levels = mipLevels(mesh);
  ASSERT_EQ(levels.size(), 7u);
  EXPECT_EQ(levels.back().size, glm::ivec2(1));
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_NEAR(alphaCoverage(levels[i], 0.5f), alphaCoverage(levels[0], 0.5f), 0.08f) << "level " << i;
    EXPECT_NEAR(levels[i].pixels[1], 160, 2) << "what is cut away doesn't darken the colour";
  }
  EXPECT_TRUE(mipLevels(PlantMesh{}).empty());
}

}  // namespace
}  // namespace windloom
