#include "engine/model/project.hpp"

#include <algorithm>

namespace windloom {

bool Project::sameAs(const Project& other) const {
  return name == other.name && field == other.field && solver == other.solver && ambient == other.ambient &&
         graph == other.graph && obstacles == other.obstacles && terrain == other.terrain && grass == other.grass &&
         probes == other.probes && cameras == other.cameras && extra == other.extra;
}

Id nextFreeId(const Project& project) {
  Id highest = 0;
  const auto visit = [&](const auto& records) {
    for (const auto& record : records) highest = std::max(highest, record.id);
  };
  visit(project.graph->points);
  visit(project.graph->arrows);
  visit(*project.obstacles);
  visit(*project.probes);
  visit(*project.cameras);
  return highest + 1;
}

}  // namespace windloom
