#pragma once
// Obstacles as the tests write them down.

#include "engine/model/project.hpp"

namespace windloom::testing {

inline Obstacle circle(glm::vec2 centre, float radius) {
  Obstacle o;
  o.centre = centre;
  o.radius = radius;
  return o;
}

inline Obstacle box(glm::vec2 centre, glm::vec2 size, float rotation) {
  Obstacle o;
  o.shape = ObstacleShape::Box;
  o.centre = centre;
  o.size = size;
  o.rotation = rotation;
  return o;
}

}  // namespace windloom::testing
