#include <CLI/CLI.hpp>

#include "engine/cli/bezier_options.hpp"
#include "engine/cli/option_checks.hpp"

namespace windloom::cli {
namespace {

struct ViewName {
  const char* name;
  GrassView view;
};
constexpr ViewName kViews[] = {{"patches", GrassView::Patches},
                               {"culled", GrassView::Culled},
                               {"strength", GrassView::Strength},
                               {"wireframe", GrassView::Wireframe}};

struct TestName {
  const char* name;
  bool BezierCulling::*test;
};
constexpr TestName kTests[] = {{"orientation", &BezierCulling::orientation},
                               {"frustum", &BezierCulling::frustum},
                               {"distance", &BezierCulling::distance},
                               {"occlusion", &BezierCulling::occlusion}};
constexpr const char* kAllTests = "all";

}  // namespace

void addBezierOptions(CLI::App& app, BezierOptions& options) {
  std::vector<std::string> views, tests;
  for (const ViewName& view : kViews) views.emplace_back(view.name);
  for (const TestName& test : kTests) tests.emplace_back(test.name);
  tests.emplace_back(kAllTests);
  app.add_option(
         "--grass-view", options.view,
         "Bezier grass by patch, by the culling test that leaves blades out, by collision strength, or as edges of "
         "triangles: patches, culled, strength, wireframe")
      ->type_name("NAME")
      ->check(oneOf(views));
  app.add_option(
         "--no-culling", options.noTests,
         "Culling tests of Bezier blades to leave out: orientation, frustum, distance, occlusion; all: these, and "
         "the patches' test as well")
      ->type_name("TEST[,TEST]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(oneOf(tests));
  app.add_option("--samples", options.samples, "Samples a pixel: 1, 2, 4 or 8 (default: what suits the machine)")
      ->type_name("N")
      ->check(oneOf({"1", "2", "4", "8"}));
}

void applyBezierOptions(const BezierOptions& options, Session::View& view) {
  for (const ViewName& known : kViews) {
    if (options.view == known.name) view.grassView = known.view;
  }
  for (const std::string& name : options.noTests) {
    for (const TestName& known : kTests) {
      if (name == known.name || name == kAllTests) view.bezierCulling.*known.test = false;
    }
    if (name == kAllTests) view.quality.culling = false;
  }
  view.quality.samples = options.samples;
}

Json bezierCountsJson(const BezierCounts& counts) {
  return {{"blades", counts.blades},
          {"patches", counts.patches},
          {"patchesSeen", counts.patchesSeen},
          {"inPatchesSeen", counts.inPatches},
          {"culled",
           {{"orientation", counts.orientation},
            {"frustum", counts.frustum},
            {"distance", counts.distance},
            {"occlusion", counts.occlusion},
            {"inSolids", counts.buried}}},
          {"drawn", counts.drawn}};
}

}  // namespace windloom::cli
