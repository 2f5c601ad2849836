#include "engine/bake/graph_gltf.hpp"

#include <gtest/gtest.h>

#include "engine/core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace {

using Json = nlohmann::ordered_json;

Point point(Id id, glm::vec2 position, const char* name = "") {
  Point made;
  made.id = id;
  made.name = name;
  made.position = position;
  return made;
}

Arrow arrow(Id id, Id from, Id to) {
  Arrow made;
  made.id = id;
  made.from = from;
  made.to = to;
  made.travelSpeed = 2;
  return made;
}

/// Two trees that merge in point 5, which the nearer root reaches first; a tip behind it.
Project merging() {
  Project project;
  project.name = "Merge";
  WindGraph graph;
  graph.points = {point(1, {0, 0}, "gate"), point(2, {20, 0}), point(5, {4, 0}), point(6, {4, 8})};
  graph.arrows = {arrow(10, 1, 5), arrow(11, 2, 5), arrow(12, 5, 6)};
  graph.arrows[0].strength = 9;
  graph.arrows[2].name = "up";
  graph.arrows[2].swirl = 1.5f;
  graph.signals.resize(1);
  graph.signals[0].root = 1;
  graph.signals[0].kind = SignalKind::Pulse;
  graph.signals[0].period = 3;
  project.graph = std::make_shared<WindGraph>(graph);
  return project;
}

Json sceneOf(const Project& project, std::span<const BakedFile> files = {}) {
  return Json::parse(graphGltfText(project, BakeHeader{}, files));
}

const Json& nodeNamed(const Json& gltf, const std::string& name) {
  for (const Json& node : gltf["nodes"]) {
    if (node["name"] == name) return node;
  }
  ADD_FAILURE() << "no node " << name;
  static const Json kNone = Json::object();
  return kNone;
}

}  // namespace

TEST(GraphGltf, GivesEachArrowToTheTreeThatReachesItFirst) {
  const Json gltf = sceneOf(merging());
  const Json& gate = nodeNamed(gltf, "AGC_gate");
  const Json& other = nodeNamed(gltf, "AGC_2");
  EXPECT_EQ(gltf["scenes"][0]["nodes"].size(), 2u);
  EXPECT_EQ(gate["children"].size(), 2u);
  EXPECT_EQ(other["children"].size(), 1u);
  EXPECT_EQ(gltf["nodes"][gate["children"][1].get<std::size_t>()]["name"], "up");
  EXPECT_EQ(gate["extras"]["signal"]["kind"], "pulse");
  EXPECT_EQ(gate["extras"]["signal"]["period"], 3.0);
}

TEST(GraphGltf, TellsEachArrowsPlaceAndSettings) {
  const Json gltf = sceneOf(merging());
  const Json& first = nodeNamed(gltf, "arrow 10")["extras"];
  EXPECT_EQ(first["kind"], "root");
  EXPECT_EQ(first["strength"], 9.0);
  EXPECT_EQ(first["drive"], "speed");
  EXPECT_EQ(first["reached"], 0.0);
  const Json& up = nodeNamed(gltf, "up");
  EXPECT_EQ(up["extras"]["kind"], "tip");
  EXPECT_EQ(up["extras"]["reached"], 2.0);
  EXPECT_EQ(up["extras"]["length"], 8.0);
  EXPECT_EQ(up["extras"]["swirl"], 1.5);
  EXPECT_EQ(up["translation"], (Json{4.0, 0.0, 0.0}));
  EXPECT_EQ(up["rotation"], (Json{0, 0.0, 0, 1.0})) << "+Z already points along it";
  // A quarter turn from +Z to -X.
  EXPECT_NEAR(nodeNamed(gltf, "arrow 11")["rotation"][1].get<double>(), -0.70710678, 1e-7);
}

TEST(GraphGltf, NamesTheFilesOfTheBake) {
  const std::vector<BakedFile> files = {{"wind.npy", "field", "float32"}};
  const Json wind = sceneOf(merging(), files)["scenes"][0]["extras"]["wind"];
  EXPECT_EQ(wind["version"], 1);
  EXPECT_EQ(wind["project"], "Merge");
  EXPECT_EQ(wind["maps"][0]["path"], "wind.npy");
}

TEST(GraphGltf, HasNoEmptyListsWithoutArrows) {
  Project project;
  const Json gltf = sceneOf(project);
  EXPECT_EQ(gltf["asset"]["version"], "2.0");
  for (const char* key : {"nodes", "meshes", "accessors", "bufferViews", "buffers", "materials"})
    EXPECT_FALSE(gltf.contains(key)) << key;
  EXPECT_FALSE(gltf["scenes"][0].contains("nodes"));
}

TEST(GraphGltf, ReplacesWhatIsNoUtf8) {
  Project project = merging();
  project.name = "a\xff";
  EXPECT_FALSE(sceneOf(project).is_discarded());
}

TEST(GraphGltf, IsAFileOfTheBake) {
  const TemporaryFolder folder;
  const Result<BakedFile> file = writeGraphGltf(merging(), BakeHeader{}, {}, folder.path());
  ASSERT_TRUE(file);
  EXPECT_EQ(file->path, "graph.gltf");
  EXPECT_EQ(file->role, "graph");
  EXPECT_EQ(readFile(folder.path() / "graph.gltf").value(), graphGltfText(merging(), BakeHeader{}, {}));
  const Result<BakedFile> refused = writeGraphGltf(merging(), BakeHeader{}, {}, "/nonexistent/folder");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::Machine);
}

}  // namespace windloom
