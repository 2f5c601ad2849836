#include "engine/model/validate.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "engine/model/parameters.hpp"
#include "tests/unit/model/model_fixture.hpp"

namespace windloom {
namespace {

std::vector<Problem> problemsOf(WindGraph graph) { return validate(projectOf(std::move(graph))); }

template <class Owner>
void expectLegalDefaults() {
  const Owner owner{};
  for (const Parameter<Owner>& parameter : parametersOf<Owner>()) {
    if (parameter.info.type == ParameterType::Id) continue;  // 0 stands for none until a project gives one
    EXPECT_EQ(parameterProblem(parameter.info, parameter.get(owner)), "") << parameter.info.key;
    EXPECT_FALSE(parameter.info.help.empty()) << parameter.info.key;
  }
}

}  // namespace

TEST(Validate, TakesTheDefaultsAndASmallTree) {
  EXPECT_TRUE(validate(Project{}).empty());
  EXPECT_TRUE(problemsOf(smallTree()).empty());
}

TEST(Validate, NamesDanglingAndDuplicateIds) {
  WindGraph graph = smallTree();
  graph.arrows[1].to = 99;
  graph.points[3].id = 1;
  const std::vector<Problem> problems = problemsOf(graph);
  EXPECT_TRUE(hasProblem(problems, "/graph/arrows/1/to"));
  EXPECT_TRUE(hasProblem(problems, "/graph/points/3/id"));
}

TEST(Validate, NamesArrowsWithoutLengthAndTwins) {
  WindGraph graph = smallTree();
  graph.points[2].position = graph.points[1].position;
  graph.arrows.push_back(arrowBetween(13, 1, 2));
  graph.arrows.push_back(arrowBetween(14, 3, 3));
  const std::vector<Problem> problems = problemsOf(graph);
  EXPECT_GE(problems.size(), 3u);
  const auto about = [&](const std::string& start) {
    for (const Problem& problem : problems) {
      if (problem.pointer.rfind(start, 0) == 0) return true;
    }
    return false;
  };
  EXPECT_TRUE(about("/graph/arrows/1"));
  EXPECT_TRUE(about("/graph/arrows/3"));
  EXPECT_TRUE(about("/graph/arrows/4"));
}

TEST(Validate, NamesSignalsOfMissingPointsAndUnorderedKeys) {
  WindGraph graph = smallTree();
  graph.signals.resize(2);
  graph.signals[0].root = 55;
  graph.signals[1].root = 1;
  graph.signals[1].kind = SignalKind::Curve;
  graph.signals[1].keys = {{2, 1}, {1, 1}};
  const std::vector<Problem> problems = problemsOf(graph);
  EXPECT_TRUE(hasProblem(problems, "/graph/signals/0/root"));
  EXPECT_GE(problems.size(), 2u);
}

TEST(Validate, PeriodicSidesNeedTheirPartner) {
  Project project;
  FieldSettings field;
  field.xMin = Border::Periodic;
  project.field = std::make_shared<FieldSettings>(field);
  EXPECT_FALSE(validate(project).empty());
  field.xMax = Border::Periodic;
  project.field = std::make_shared<FieldSettings>(field);
  EXPECT_TRUE(validate(project).empty());
}

TEST(Validate, RefusesNumbersThatAreNotFinite) {
  for (float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    WindGraph graph = smallTree();
    graph.points[0].position.x = bad;
    EXPECT_TRUE(hasProblem(problemsOf(graph), "/graph/points/0/position"));
  }
}

TEST(Parameters, DefaultsAreLegalAndExplained) {
  expectLegalDefaults<FieldSettings>();
  expectLegalDefaults<SolverSettings>();
  expectLegalDefaults<AmbientWind>();
  expectLegalDefaults<Point>();
  expectLegalDefaults<Arrow>();
  expectLegalDefaults<Signal>();
  expectLegalDefaults<Obstacle>();
  expectLegalDefaults<Probe>();
  expectLegalDefaults<Camera>();
  expectLegalDefaults<TerrainSettings>();
  expectLegalDefaults<GrassSettings>();
}

TEST(Parameters, ProblemsNameWhatWasFoundAndExpected) {
  for (const Parameter<Arrow>& parameter : parametersOf<Arrow>()) {
    if (parameter.info.key != "radius") continue;
    const std::string problem = parameterProblem(parameter.info, -3.0f);
    EXPECT_NE(problem.find("-3"), std::string::npos) << problem;
    EXPECT_NE(problem.find("expected"), std::string::npos) << problem;
    return;
  }
  FAIL() << "arrows have a radius";
}

}  // namespace windloom
