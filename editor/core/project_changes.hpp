#pragma once
// The differences between two projects in words, for recovery and for whoever compares versions.

#include <string>
#include <vector>

#include "engine/model/project.hpp"

namespace windloom::editor {

/// One line each: "2 arrows added", "Point 3 (gate) changed: position", "Field changed: size, time step". Empty
/// where the two hold the same.
std::vector<std::string> describeChanges(const Project& before, const Project& after);

}  // namespace windloom::editor
