// The samples of shell grass hold what their READMEs say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/file.hpp"
#include "engine/io/project_json.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/model/height_field.hpp"

namespace windloom {
namespace {

std::string pathOf(const std::string& name) {
  return WINDLOOM_PROJECTS "/" + name + "/" + name + ".wind.json";
}

Project sample(const std::string& name) {
  const auto loaded = loadProject(pathOf(name));
  EXPECT_TRUE(loaded.ok()) << loaded.error().text();
  if (!loaded) return {};
  EXPECT_TRUE(loaded->warnings.empty()) << name;
  EXPECT_TRUE(loaded->missing.empty()) << name;
  return loaded->project;
}

const Camera* cameraOf(const Project& project, const std::string& name) {
  for (const Camera& camera : *project.cameras) {
    if (camera.name == name) return &camera;
  }
  return nullptr;
}

TEST(SampleShell, AreWrittenAsTheEditorWritesThem) {
  for (const char* name : {"prairie", "knoll"}) {
    const Project project = sample(name);
    EXPECT_EQ(project.grass->kind, GrassKind::Shell) << name;
    EXPECT_EQ(project.shell->method, ShellMethod::Filled) << name;
    EXPECT_EQ(project.cameras->front().name, "hero") << name;
    const Result<std::string> text = readFile(pathOf(name));
    ASSERT_TRUE(text.ok());
    EXPECT_EQ(writeProject(project), *text) << name;
  }
}

TEST(SampleShell, PrairiesGustComesUpAtTheLeftOfThePicture) {
  const Project project = sample("prairie");
  const Camera* hero = cameraOf(project, "hero");
  ASSERT_NE(hero, nullptr);
  const glm::vec3 ahead = glm::normalize(hero->target - hero->position);
  const glm::vec3 right = glm::normalize(glm::cross(ahead, glm::vec3(0, 1, 0)));
  const auto across = [&](glm::vec2 place) {
    return glm::dot(glm::vec3(place.x, 0, place.y) - hero->position, right);
  };
  const GraphEvaluator evaluator(*project.graph);
  const std::vector<Arrival>& arrivals = evaluator.arrivals();
  ASSERT_EQ(arrivals.size(), project.graph->points.size());
  EXPECT_EQ(arrivals.front().time, 0.0) << "the root comes first";
  EXPECT_LT(across(project.graph->points.front().position), -50.0f);
  float farthest = 0;
  for (const Arrow& arrow : project.graph->arrows) {
    const auto indexOf = [&](Id id) {
      const auto found = std::find_if(project.graph->points.begin(), project.graph->points.end(),
                                      [&](const Point& point) { return point.id == id; });
      return static_cast<std::size_t>(found - project.graph->points.begin());
    };
    const std::size_t from = indexOf(arrow.from), to = indexOf(arrow.to);
    ASSERT_LT(std::max(from, to), arrivals.size());
    const float begin = across(project.graph->points[from].position), end = across(project.graph->points[to].position);
    EXPECT_GT(end, begin + 5.0f) << "arrow " << arrow.id << " leads to the right";
    EXPECT_GT(arrivals[to].time, arrivals[from].time + 0.5) << "arrow " << arrow.id;
    farthest = std::max(farthest, end);
  }
  EXPECT_GT(farthest, 45.0f) << "it crosses the picture";
}

TEST(SampleShell, PrairiesGustIsAFrontThatCrossesOnceInAPeriod) {
  const Project project = sample("prairie");
  ASSERT_EQ(project.graph->signals.size(), 1u);
  EXPECT_EQ(project.graph->signals.front().kind, SignalKind::Pulse);
  EXPECT_NEAR(project.graph->signals.front().period, 8.0f, 0.1f);
  const GraphEvaluator evaluator(*project.graph);
  // The middle of what blows moves to the right, at a walk of the signal's speed.
  const auto middle = [&](double time) {
    double sum = 0, weight = 0;
    for (const ArrowForce& force : evaluator.forcesAt(time)) {
      sum += 0.5 * static_cast<double>(force.from.x + force.to.x) * static_cast<double>(force.factor);
      weight += static_cast<double>(force.factor);
    }
    EXPECT_GT(weight, 0) << "something blows at " << time;
    return sum / std::max(weight, 1e-9);
  };
  double before = middle(2.0);
  EXPECT_LT(before, -35.0);
  for (double time = 3.0; time < 7.6; time += 1.0) {
    const double here = middle(time);
    EXPECT_GT(here, before + 6.0) << "at " << time << " s";
    EXPECT_LT(here, before + 15.0) << "at " << time << " s";
    before = here;
  }
  // Lanes beside each other keep in step: one front, not three.
  const std::vector<Arrival>& arrivals = evaluator.arrivals();
  for (std::size_t i = 1; i < arrivals.size(); ++i) {
    for (std::size_t k = 1; k < i; ++k) {
      const glm::vec2 a = project.graph->points[i].position, b = project.graph->points[k].position;
      if (std::abs(a.x - b.x) > 0.1f) continue;
      EXPECT_NEAR(arrivals[i].time, arrivals[k].time, 0.2) << "at x " << a.x;
    }
  }
}

TEST(SampleShell, PrairieHasTheCamerasThatPicturesAndTheBenchmarkNeed) {
  const Project project = sample("prairie");
  for (const char* name : {"hero", "air", "grazing", "near", "top", "worst"}) {
    EXPECT_NE(cameraOf(project, name), nullptr) << name;
  }
  const Camera* worst = cameraOf(project, "worst");
  ASSERT_NE(worst, nullptr);
  const glm::vec3 ahead = glm::normalize(worst->target - worst->position);
  const float down = glm::degrees(std::asin(-ahead.y));
  EXPECT_NEAR(down, 35.0f, 1.0f);
  EXPECT_LT(0.5f * worst->fieldOfView, down) << "no sky in it";
}

TEST(SampleShell, AHareStandsByTheKnoll) {
  const Project project = sample("knoll");
  ASSERT_EQ(project.surfaces->size(), 1u);
  EXPECT_EQ(project.surfaces->front().shape, SurfaceShape::Hare);
  EXPECT_GT(project.surfaces->front().density, 0.0f);
  // One rounded knoll: its top is in the middle, and higher than all that is farther away.
  ASSERT_NE(project.terrain->heights, nullptr);
  const HeightField& heights = *project.terrain->heights;
  const float top = heightAt(heights, {0, 0});
  EXPECT_GT(top, 5.0f);
  for (float angle = 0; angle < 6.28f; angle += 0.1f) {
    EXPECT_LT(heightAt(heights, 18.0f * glm::vec2(std::cos(angle), std::sin(angle))), 0.5f * top) << angle;
  }
}

}  // namespace
}  // namespace windloom
