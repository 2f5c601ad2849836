#include "engine/io/project_schema.hpp"

#include <gtest/gtest.h>

#include "engine/core/file.hpp"

namespace windloom {
namespace {

std::string inDocs(const std::string& name) {
  const Result<std::string> text = readFile(WINDLOOM_DOCS "/" + name);
  EXPECT_TRUE(text.ok()) << text.error().text();
  return text ? *text : std::string();
}

}  // namespace

TEST(ProjectSchema, FileInDocsIsUpToDate) {
  EXPECT_EQ(inDocs("project.schema.json"), projectSchemaJson()) << "run: windloom docs docs";
}

TEST(ParametersMarkdown, FileInDocsIsUpToDate) {
  EXPECT_EQ(inDocs("parameters.md"), parametersMarkdown()) << "run: windloom docs docs";
}

}  // namespace windloom
