#pragma once
// Species to begin with: measures and colours that suit each shape.

#include "engine/model/project.hpp"

namespace windloom {

/// Named after its kind, without an id; a mesh is without its file.
Species speciesPreset(PlantShape shape);

}  // namespace windloom
