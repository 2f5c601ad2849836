#include "shaders/shared/speed_colour.h"

#include "engine/render/frame_renderer.hpp"

namespace windloom {

glm::vec3 speedColour(float t) { return shared::speedColourAt(t); }

}  // namespace windloom
