#pragma once
// Older project files, brought up to date on load. Each change of the format adds one function that
// turns a document of version N into one of version N + 1, and a file of version N under tests/data.

#include <span>

#include "engine/core/result.hpp"
#include "engine/io/json_document.hpp"

namespace windloom {

struct ProjectMigration {
  int from = 0;  ///< turns a document of this version into one of the next
  void (*apply)(JsonDocument& document) = nullptr;
};

/// The migrations this program knows, in ascending order.
std::span<const ProjectMigration> projectMigrations();

/// Brings a document of version `from` to version `to` (from <= to), "version" included. Fails with BadInput where a
/// step is missing from the table or the document is too broken for it.
Status migrateProject(JsonDocument& document, int from, int to, std::span<const ProjectMigration> migrations);

}  // namespace windloom
