// The project file: whatever it is given as text. What loads must be valid, be written and read again as it was, blow
// finite winds, and take edits without becoming invalid.

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/io/project_json.hpp"
#include "engine/model/collider_motion.hpp"
#include "engine/model/edit.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/model/parameters.hpp"
#include "engine/model/surface_pose.hpp"
#include "engine/model/validate.hpp"
#include "tests/fuzz/support/fuzz_target.hpp"

using namespace windloom;
using fuzz::require;

namespace {

constexpr double kMoments[] = {0.0, 0.51, 7.25, 3600.0, 1e6};

/// Groups of a part are written where its table has them, so unknown keys beside them may change places: what counts is
/// that each is there with its value.
bool sameKeys(const std::string& a, const std::string& b) {
  return a == b || (!a.empty() && !b.empty() && nlohmann::json::parse(a) == nlohmann::json::parse(b));
}

template <class Part>
void requireSame(const Part& a, const Part& b) {
  for (const Parameter<Part>& parameter : parametersOf<Part>())
    require(parameter.get(a) == parameter.get(b),
            "written and read again it is as it was: " + std::string(parameter.info.key));
  require(sameKeys(a.extra, b.extra), "unknown keys are kept");
}

void requireSameProject(const Project& a, const Project& b) {
  require(a.name == b.name && a.extra && b.extra && *a.extra == *b.extra, "name and unknown keys are kept");
  requireSame(*a.field, *b.field);
  requireSame(*a.solver, *b.solver);
  requireSame(*a.ambient, *b.ambient);
  requireSame(*a.terrain, *b.terrain);
  requireSame(*a.grass, *b.grass);
  requireSame(*a.bezier, *b.bezier);
  requireSame(*a.shell, *b.shell);
  require(a.graph->points == b.graph->points && a.graph->arrows == b.graph->arrows, "the graph is as it was");
  require(a.graph->signals == b.graph->signals && a.graph->extra == b.graph->extra, "the signals are as they were");
  require(*a.obstacles == *b.obstacles && *a.species == *b.species && *a.colliders == *b.colliders,
          "obstacles, species and colliders are as they were");
  require(*a.surfaces == *b.surfaces && *a.rotors == *b.rotors && *a.probes == *b.probes && *a.cameras == *b.cameras,
          "surfaces, rotors, probes and cameras are as they were");
}

void tryWriting(const LoadedProject& loaded) {
  const std::string once = writeProject(loaded.project);
  const Result<LoadedProject> again = parseProject(once, "again");
  require(again.ok(), "what was written can be read: " + (again ? "" : again.error().text()));
  require(writeProject(again->project) == once, "writing and reading changes nothing");
  require(again->warnings.size() == loaded.warnings.size(), "unknown keys are told again");
  requireSameProject(loaded.project, again->project);
}

bool finite(glm::vec2 v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}
bool finite(glm::vec3 v) {
  return finite(glm::vec2(v)) && std::isfinite(v.z);
}

void tryWind(const Project& project) {
  require(finite(ambientVelocity(*project.ambient)), "the ambient wind is a number");
  const GraphEvaluator evaluator(*project.graph);
  for (const double moment : kMoments) {
    for (const ArrowForce& force : evaluator.forcesAt(moment)) {
      require(finite(force.from) && finite(force.to) && finite(force.direction), "a force has a place");
      require(std::isfinite(force.radius) && std::isfinite(force.strength) && std::isfinite(force.response) &&
                  std::isfinite(force.swirl) && std::isfinite(force.factor),
              "a force is a number");
    }
    for (const Collider& collider : *project.colliders) {
      require(finite(colliderOffset(collider, moment)) && finite(colliderVelocity(collider, moment)) &&
                  std::isfinite(colliderHeading(collider, moment)) &&
                  finite(colliderPose(collider, nullptr, moment).centre),
              "a collider is somewhere");
    }
  }
  for (const Surface& surface : *project.surfaces)
    require(finite(glm::vec3(surfacePose(surface, nullptr)[3])), "a surface is somewhere");
}

std::vector<Id> idsOf(const Project& project) {
  std::vector<Id> ids;
  const auto add = [&](const auto& records) {
    for (const auto& record : records) ids.push_back(record.id);
  };
  add(project.graph->points);
  add(project.graph->arrows);
  add(*project.obstacles);
  add(*project.species);
  add(*project.colliders);
  add(*project.surfaces);
  add(*project.rotors);
  add(*project.probes);
  add(*project.cameras);
  return ids;
}

void tryEdit(const Project& project, const Edit& edit) {
  const Result<Project> changed = applyEdit(project, edit);
  if (!changed) return;
  require(validate(*changed).empty(), "an edit that is taken leaves a valid project");
  require(parseProject(writeProject(*changed), "edited").ok(), "an edited project can be read");
}

void tryEdits(const Project& project) {
  const std::vector<Id> ids = idsOf(project);
  tryEdit(project, moveEdit(project, ids, {3.25f, -1e4f}));
  std::vector<Id> some;
  for (std::size_t i = 0; i < ids.size(); i += 2) some.push_back(ids[i]);
  tryEdit(project, eraseEdit(some));
  if (!ids.empty()) tryEdit(project, {"Reorder", {Reorder{{ids.back()}, ids.front()}}, {}});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzz::asText(data, size));
  const Result<LoadedProject> loaded = parseProject(text, "fuzz");
  if (!loaded) {
    require(!loaded.error().problems.empty() && !loaded.error().text().empty(), "a refusal says why");
    return 0;
  }
  require(validate(loaded->project).empty(), "what loads is valid");
  tryWriting(*loaded);
  tryWind(loaded->project);
  tryEdits(loaded->project);
  return 0;
}
