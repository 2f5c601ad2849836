#include "shaders/shared/speed_colour.h"

#include "engine/render/frame_renderer.hpp"
#include "shaders/shared/diverging_colour.h"

namespace windloom {

glm::vec3 speedColour(float t) {
  return shared::speedColourAt(t);
}

glm::vec3 divergingColour(float t) {
  return shared::divergingColourAt(t);
}

}  // namespace windloom
