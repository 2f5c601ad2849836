#include "engine/io/project_migration.hpp"

#include <gtest/gtest.h>

#include <array>

namespace windloom {
namespace {

constexpr std::array kSteps{
    ProjectMigration{1,
                     [](JsonDocument& d) {
                       d["wind"] = d.at("breeze");
                       d.erase("breeze");
                     }},
    ProjectMigration{2, [](JsonDocument& d) { d["wind"] = d.at("wind").get<double>() * 2; }},
};

}  // namespace

TEST(ProjectMigration, AppliesEachStepInTurn) {
  JsonDocument document{{"version", 1}, {"breeze", 4}};
  ASSERT_TRUE(migrateProject(document, 1, 3, kSteps).ok());
  EXPECT_EQ(document, (JsonDocument{{"version", 3}, {"wind", 8.0}}));
}

TEST(ProjectMigration, LeavesTheCurrentVersionAlone) {
  JsonDocument document{{"version", 3}, {"breeze", 4}};
  ASSERT_TRUE(migrateProject(document, 3, 3, kSteps).ok());
  EXPECT_EQ(document, (JsonDocument{{"version", 3}, {"breeze", 4}}));
}

TEST(ProjectMigration, RefusesAVersionWithoutStep) {
  JsonDocument document{{"version", 0}};
  const Status status = migrateProject(document, 0, 3, kSteps);
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().problems[0].pointer, "/version");
}

TEST(ProjectMigration, RefusesADocumentTooBrokenForAStep) {
  JsonDocument document{{"version", 2}, {"wind", "strong"}};
  EXPECT_FALSE(migrateProject(document, 2, 3, kSteps).ok());
}

}  // namespace windloom
