#pragma once
// What an image file tells about itself, for formats that have room for names and texts.

#include <string>
#include <utility>
#include <vector>

#include "engine/bake/target_frame.hpp"

namespace windloom {

/// Names in alphabetical order with their texts: axes, bounds, fps, frames, lengthUnit, loop, preset, space, start,
/// track, unit, wrap. docs/formats.md lists them. Numbers are the shortest text that reads back as the same float.
std::vector<std::pair<std::string, std::string>> flowFacts(const BakeHeader& header, const TargetFrame& target);

}  // namespace windloom
