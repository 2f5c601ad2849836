#include <gtest/gtest.h>

#include <cmath>

#include "engine/model/templates.hpp"
#include "tests/unit/io/project_fixture.hpp"

namespace windloom {
namespace {

Project read(const std::string& text) {
  Result<LoadedProject> loaded = parseProject(text, "text");
  EXPECT_TRUE(loaded.ok()) << loaded.error().text();
  return std::move(loaded->project);
}

}  // namespace

TEST(ProjectJson, WritingWhatWasReadGivesTheSameBytes) {
  const std::string once = writeProject(read(kRichProject));
  EXPECT_EQ(writeProject(read(once)), once);
  for (const ProjectTemplate& entry : projectTemplates()) {
    const std::string text = writeProject(entry.make());
    EXPECT_EQ(writeProject(read(text)), text) << entry.name;
  }
}

TEST(ProjectJson, UnknownKeysAreWrittenBackAtTheirObject) {
  const std::string text = writeProject(read(kRichProject));
  for (const char* kept :
       {R"("floor": "moss"})", R"("later": [1, {"a": null}]})", R"("colour": "blue"})", R"("tag": 0.001})",
        R"("layers": {"x": 1})", R"("studio": {"owner": "Ada", "big": 18446744073709551615})",
        R"("maps": {"density": "assets/mask.png", "wet": 1})", R"("season": "may"})", R"("mass": 3})", R"("moss": 2})",
        R"("dew": true})", R"("ply": 2})", R"("mow": "weekly"})", R"("grain": 3})", R"("noise": "loud"})"}) {
    EXPECT_NE(text.find(kept), std::string::npos) << kept << "\n" << text;
  }
}

TEST(ProjectJson, WritesOneRecordALineWithoutDefaults) {
  const std::string text = writeProject(read(kRichProject));
  for (const char* line :
       {"\n      {\"id\": 1, \"name\": \"gate\", \"position\": [-10, 0]},\n",
        "\n      {\"id\": 10, \"from\": 1, \"to\": 2, \"drive\": \"speed\", \"strength\": 9, \"radius\": 4, \"where\": "
        "\"along\", \"swirl\": -1.5},\n",
        "\n      {\"root\": 1, \"kind\": \"curve\", \"period\": 4, \"attack\": 0.4, \"loop\": true, \"keys\": [[0, 0], "
        "[1.25, 1], [4, 0]]}\n",
        "\n    {\"id\": 30, \"shape\": \"box\", \"centre\": [5, -8], \"size\": [3, 1], \"rotation\": 30}\n",
        "\n    {\"id\": 60, \"shape\": \"daisy\", \"weight\": 0.1, \"height\": 0.8, \"colours\": {\"tip\": [1, 1, "
        "0.9]}},\n",
        "\n    {\"id\": 70, \"shape\": \"sphere\", \"position\": [2, 3], \"radius\": 0.4, \"keys\": [[0, 0, 0, 0], "
        "[1.5, 4, 0.25, -2]], \"mass\": 3},\n",
        "\n    {\"id\": 71, \"shape\": \"mesh\", \"position\": [0, 0], \"file\": \"assets/rock.glb\"}\n",
        "\n    {\"id\": 80, \"name\": \"band\", \"shape\": \"moebius\", \"position\": [1, 2], \"size\": 6, \"tilt\": "
        "20, "
        "\"density\": 900, \"height\": 0.15, \"bothSides\": true},\n",
        "\n    {\"id\": 81, \"shape\": \"mesh\", \"position\": [4, 4], \"file\": \"assets/stone.glb\", \"density\": "
        "1500, "
        "\"height\": 0.15, \"grain\": 3}\n",
        "\n    {\"id\": 90, \"position\": [-3, 1], \"lift\": 8, \"radius\": 4, \"speed\": 16, \"rings\": 0.8, "
        "\"noise\": \"loud\"}\n",
        "\n    {\"id\": 40, \"position\": [3, 4]}\n"}) {
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
  }
}

TEST(ProjectJson, FilesFromBeforeASettingOrListGetItsDefault) {
  const std::string text = writeProject(read(R"({"format": "windloom-project", "version": 1})"));
  const char* lists =
      "},\n  \"species\": [],\n  \"colliders\": [],\n  \"surfaces\": [],\n  \"rotors\": [],\n  \"probes\": []";
  EXPECT_NE(text.find(lists), std::string::npos) << text;
  EXPECT_NE(text.find("},\n  \"bezier\": {\"most\": 1000000, \"tufts\": {\"share\": 0.35,"), std::string::npos) << text;
  EXPECT_NE(text.find("},\n  \"shell\": {\"shells\": 8, \"method\": \"filled\","), std::string::npos) << text;
  EXPECT_EQ(text.find("\"maps\""), std::string::npos) << "no maps, no key";
  EXPECT_NE(text.find(R"("swing": {"rate": 1.4, "damping": 0.18, "exponent": 1.3333334})"), std::string::npos) << text;
}

TEST(ProjectJson, EasingsOfKeysSurviveAndLinearIsLeftOut) {
  Project project = read(kRichProject);
  WindGraph graph = *project.graph;
  graph.signals[0].keys[0].easing = Easing::Smooth;
  graph.signals[0].keys[1].easing = Easing::Hold;
  project.graph = std::make_shared<WindGraph>(graph);
  const std::string text = writeProject(project);
  EXPECT_NE(text.find(R"("keys": [[0, 0, "smooth"], [1.25, 1, "hold"], [4, 0]])"), std::string::npos) << text;
  EXPECT_EQ(read(text).graph->signals[0].keys, graph.signals[0].keys);
}

TEST(ProjectJson, WritesTheShortestNumbers) {
  Project project;
  AmbientWind ambient;
  ambient.speed = 0.1f;
  ambient.direction = -0.0f;
  project.ambient = std::make_shared<AmbientWind>(ambient);
  const std::string text = writeProject(project);
  EXPECT_NE(text.find("\"speed\": 0.1,"), std::string::npos);
  EXPECT_NE(text.find("\"direction\": 0,"), std::string::npos);
  EXPECT_NE(text.find("\"timeStep\": 0.016666668"), std::string::npos);
}

TEST(ProjectJson, EveryFloatComesBackAsItWas) {
  Project project;
  auto points = std::make_shared<WindGraph>();
  std::uint32_t state = 1;
  for (Id id = 1; id <= 2000; ++id) {
    state = state * 1664525u + 1013904223u;
    Point point;
    point.id = id;
    point.position = {static_cast<float>(static_cast<std::int32_t>(state)) / 3000.0f,
                      std::ldexp(1.1f, static_cast<int>(id % 60) - 50)};
    points->points.push_back(point);
  }
  project.graph = points;
  const Project back = read(writeProject(project));
  ASSERT_EQ(back.graph->points.size(), points->points.size());
  for (std::size_t i = 0; i < points->points.size(); ++i) {
    EXPECT_EQ(back.graph->points[i].position, points->points[i].position);
  }
}

TEST(ProjectJson, SamplesAreTheirTemplates) {
  const std::pair<const char*, const char*> samples[] = {
      {"meadow", "meadow"}, {"colliding-winds", "colliding-winds"}, {"canyon", "canyon-funnel"}};
  for (const auto& [sample, name] : samples) {
    const Result<std::string> text =
        readFile(WINDLOOM_PROJECTS "/" + std::string(sample) + "/" + sample + ".wind.json");
    ASSERT_TRUE(text.ok()) << text.error().text();
    EXPECT_EQ(*text, writeProject(findTemplate(name)->make())) << sample;
  }
}

}  // namespace windloom
