#pragma once
// Where shells stand along a blade, and how they move. Pure.

#include <span>
#include <vector>

#include "engine/model/project.hpp"
#include "shaders/shared/shell_bend.h"

namespace windloom {

/// For |I| = k / (intensities - 1) * limit and each segment's end i = 0..segments, row by row: n_i - n_0 and w_i - w_0
/// in heights of the blade (S = 1 / segments). The paper's sums begin with j = 0, which would lift the ground itself by
/// S; here the ground stays. Negative I has the same n and -w.
std::vector<glm::vec2> shellOffsetTable(int segments, int intensities, float limit, float stiffness);

struct ShellPlacing {
  std::vector<int> ends;  ///< segments' ends that shells stand at, ascending, the last is `segments`
  float error = 0;        ///< how far a straight line between two shells lies from the bent blade at most, in heights
};

/// `shells` evenly spaced ones, as far as whole segments allow.
ShellPlacing evenShells(int segments, int shells, float limit, float stiffness);

/// Where the largest error is least: shells stand close where blades bend and where blades are seen. `reaching`: part
/// of the ground covered by blades at least i / (size - 1) high, falling; an error counts as much as the blades that
/// reach it. `among`: ends that they may be chosen from (a finer placing); empty: all. ShellPlacing::error is as above,
/// without the weight.
ShellPlacing placeShells(int segments, int shells, float limit, float stiffness, std::span<const float> reaching,
                         std::span<const int> among = {});

}  // namespace windloom
