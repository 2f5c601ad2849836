#include "engine/io/project_migration.hpp"

#include <algorithm>

namespace windloom {

std::span<const ProjectMigration> projectMigrations() {
  return {};
}

Status migrateProject(JsonDocument& document, int from, int to, std::span<const ProjectMigration> migrations) {
  for (int version = from; version < to; ++version) {
    const auto step = std::ranges::find(migrations, version, &ProjectMigration::from);
    if (step == migrations.end()) {
      return makeError(ErrorKind::BadInput, {}, "/version",
                       "is " + std::to_string(from) + ", which can no longer be read");
    }
    try {
      step->apply(document);
    } catch (const JsonDocument::exception& error) {
      return makeError(ErrorKind::BadInput, {}, {},
                       "is too broken to be brought from version " + std::to_string(version) + " to " +
                           std::to_string(version + 1) + ": " + error.what());
    }
    document["version"] = version + 1;
  }
  return Done{};
}

}  // namespace windloom
