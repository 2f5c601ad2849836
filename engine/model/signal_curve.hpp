#pragma once
// The curve of a signal between its keys, without onset and delay.

#include <array>
#include <string_view>

#include "engine/model/wind_graph.hpp"

namespace windloom {

/// Names in project files, index = enum value.
inline constexpr std::array<std::string_view, 3> kEasings{"linear", "smooth", "hold"};

/// After how many seconds the curve repeats; 0: never.
double curvePeriod(const Signal& signal);

/// The curve at `t` seconds after its start, within the values of its keys. One that loops joins its last
/// key to the first of the next round, with the last key's easing; one that doesn't holds its first and last
/// values outside its keys. No keys: always 1.
double curveAt(const Signal& signal, double t);

}  // namespace windloom
