#pragma once
// Maps of a field as pictures: colours, solids, a colour bar with its numbers.

#include <functional>
#include <string>

#include "engine/io/image.hpp"
#include "engine/wind/wind_grid.hpp"

namespace windloom::testing {

enum class ColourMap {
  Speed,    ///< 0 to the range: shaders/shared/speed_colour.h
  Turning,  ///< minus to plus the range: blue over white to red, a colour-blind safe diverging map
};

struct FieldPicture {
  glm::vec2 low, high;  ///< corners of the part that is shown, m
  int width = 512;      ///< pixels; the height follows
  ColourMap map = ColourMap::Speed;
  double range = 1;  ///< what the ends of the map stand for; beyond it colours stay
  std::string unit;  ///< of the range
};

/// +X to the right, +Z up. `value` at a place (m); solids of `grid` are grey.
Image drawField(const FieldPicture& picture, const WindGrid& grid, const std::function<double(glm::vec2)>& value);

}  // namespace windloom::testing
