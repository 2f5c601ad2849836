#pragma once
// The gusts of the ambient wind, made the same for both backends: one cyclic table of noise, and the places of its
// copies at a moment. Source: Belyaev, Laevsky & Chukanov, Real-Time Animation, Collision and Rendering of
// Grassland, 2011 (wind texture). docs/solver.md section 3.

#include <array>
#include <vector>

#include "engine/model/project.hpp"
#include "shaders/shared/wind_constants.h"
#include "shaders/shared/wind_gust.h"

namespace windloom {

using shared::WindGustLayer;

/// WIND_GUST_TABLE squared (along, across) velocities, row by row, wrapping at its sides: the curl of a seeded gradient
/// noise, with a root mean square length of 1.
std::vector<glm::vec2> makeGustTable(int seed);

/// The copies of the table at `time` (s).
std::array<WindGustLayer, WIND_GUST_LAYERS> gustLayersAt(const AmbientWind& ambient, double time);

/// The gust field at a place, about 0.7 in root mean square; times gustStrength * speed it is in m/s.
glm::vec2 gustAt(const std::vector<glm::vec2>& table, const std::array<WindGustLayer, WIND_GUST_LAYERS>& layers,
                 glm::vec2 world);

/// gustStrength * speed, m/s; 0: no gusts.
float gustAmplitude(const AmbientWind& ambient);

}  // namespace windloom
