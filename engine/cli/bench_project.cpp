#include "engine/cli/bench_project.hpp"

#include <cmath>
#include <numbers>

#include "engine/cli/common.hpp"
#include "engine/core/file.hpp"
#include "engine/core/hash.hpp"

namespace windloom::cli {
namespace {

std::shared_ptr<const WindGraph> scatteredArrows(float size, int count) {
  auto graph = std::make_shared<WindGraph>();
  const float length = std::min(8.0f, 0.25f * size);
  for (int n = 0; n < count; ++n) {
    const auto seed = static_cast<std::uint32_t>(n);
    const glm::vec2 at(hashToUnit(pcgHash(3 * seed)), hashToUnit(pcgHash(3 * seed + 1)));
    const float angle = 2.0f * std::numbers::pi_v<float> * hashToUnit(pcgHash(3 * seed + 2));
    const glm::vec2 from = (at - 0.5f) * (size - 2.0f * length);
    const Id id = 3 * seed + 1;
    graph->points.push_back({id, "", from, false, {}});
    graph->points.push_back({id + 1, "", from + length * glm::vec2(std::cos(angle), std::sin(angle)), false, {}});
    Arrow arrow;
    arrow.id = id + 2;
    arrow.from = id;
    arrow.to = id + 1;
    arrow.radius = std::min(4.0f, length);
    graph->arrows.push_back(arrow);
  }
  return graph;
}

Project windyProject(float metres, int cells, int arrows) {
  Project project;
  auto field = std::make_shared<FieldSettings>();
  field->resolution = {cells, cells};
  field->size = glm::vec2(metres);
  auto ambient = std::make_shared<AmbientWind>();
  ambient->speed = 3;
  ambient->direction = 20;
  ambient->gustStrength = 0.3f;
  project.graph = scatteredArrows(metres, arrows);
  project.field = std::move(field);
  project.ambient = std::move(ambient);
  return project;
}

}  // namespace

Project benchProject(int cells, int arrows) {
  Project project = windyProject(0.1f * static_cast<float>(cells), cells, arrows);
  project.name = "Benchmark";
  return project;
}

Project benchWindyMeadow(float metres, float density, int cells) {
  Project project = windyProject(metres, cells, 10);
  project.grass = benchMeadow(metres, density).grass;
  return project;
}

Project benchMeadow(float metres, float density) {
  Project project;
  auto field = std::make_shared<FieldSettings>();
  field->size = {metres, metres};
  project.field = std::move(field);
  auto grass = std::make_shared<GrassSettings>();
  grass->density = density;
  project.grass = std::move(grass);
  return project;
}

Result<Project> benchSample(const std::string& name) {
  const Result<std::filesystem::path> folder = findDataFolder("projects");
  if (!folder) return folder.error();
  return loadWithWarnings((*folder / name / (name + ".wind.json")).string());
}

}  // namespace windloom::cli
