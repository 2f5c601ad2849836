#pragma once
// Small projects for the tests of the model.

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/model/project.hpp"

namespace windloom {

inline Point pointAt(Id id, glm::vec2 position) {
  Point point;
  point.id = id;
  point.position = position;
  return point;
}

inline Arrow arrowBetween(Id id, Id from, Id to, float travelSpeed = 10) {
  Arrow arrow;
  arrow.id = id;
  arrow.from = from;
  arrow.to = to;
  arrow.travelSpeed = travelSpeed;
  return arrow;
}

inline Project projectOf(WindGraph graph) {
  Project project;
  project.graph = std::make_shared<WindGraph>(std::move(graph));
  return project;
}

/// 1 -> 2 -> 3 along +X, 10 m each.
inline WindGraph line() {
  WindGraph graph;
  graph.points = {pointAt(1, {0, 0}), pointAt(2, {10, 0}), pointAt(3, {20, 0})};
  graph.arrows = {arrowBetween(11, 1, 2), arrowBetween(12, 2, 3)};
  return graph;
}

/// 1 -> 2 -> 3 along +X, 10 m each, and a branch 2 -> 4 of 20 m along +Z.
inline WindGraph smallTree() {
  WindGraph graph;
  graph.points = {pointAt(1, {0, 0}), pointAt(2, {10, 0}), pointAt(3, {20, 0}), pointAt(4, {10, 20})};
  graph.arrows = {arrowBetween(10, 1, 2), arrowBetween(11, 2, 3), arrowBetween(12, 2, 4)};
  return graph;
}

inline bool hasProblem(const std::vector<Problem>& problems, const std::string& pointer) {
  for (const Problem& problem : problems) {
    if (problem.pointer == pointer) return true;
  }
  return false;
}

}  // namespace windloom
