#pragma once
// What `render` lets one see of Bezier grass: debug views, culling tests one by one, what they counted.

#include <string>
#include <vector>

#include "engine/cli/common.hpp"
#include "engine/session/session.hpp"

namespace windloom::cli {

struct BezierOptions {
  std::string view;                  ///< empty: as it looks
  std::vector<std::string> noTests;  ///< culling tests that are off
  int samples = 0;                   ///< a pixel; 0: as the renderer has it
};

/// Adds --grass-view, --no-culling and --samples, which refuse what they don't know.
void addBezierOptions(CLI::App& app, BezierOptions& options);

void applyBezierOptions(const BezierOptions& options, Session::View& view);

/// The counts by name.
Json bezierCountsJson(const BezierCounts& counts);

}  // namespace windloom::cli
