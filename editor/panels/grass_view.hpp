#pragma once
// How Bezier grass is looked at: its debug views, and its culling tests with what each leaves out.

#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

/// One way to look at it: an action "grass_view.NAME" chooses it.
struct GrassViewEntry {
  GrassView view;
  const char *name, *label, *help;
};
inline constexpr GrassViewEntry kGrassViews[] = {
    {GrassView::Normal, "normal", "As it is", "The grass in its own colours."},
    {GrassView::Patches, "patches", "Patches", "Each patch of 256 blades in a colour of its own."},
    {GrassView::Culled, "culled", "What is left out", "Blades that a test leaves out, in the colour of the test."},
    {GrassView::Strength, "strength", "Touch memory", "How strongly each blade remembers what touched it."},
    {GrassView::Wireframe, "wireframe", "Wireframe", "The edges of the triangles that blades are made of."},
};

/// A test that leaves blades out: an action "cull.NAME" switches it.
struct CullingEntry {
  bool BezierCulling::*on;
  long long BezierCounts::*count;
  const char *name, *label, *help;
};
inline constexpr CullingEntry kCullingTests[] = {
    {&BezierCulling::orientation, &BezierCounts::orientation, "orientation", "Edge-on",
     "Leaves out blades that are seen from the side."},
    {&BezierCulling::frustum, &BezierCounts::frustum, "frustum", "Out of view",
     "Leaves out blades outside the picture."},
    {&BezierCulling::distance, &BezierCounts::distance, "distance", "Far away",
     "Leaves out more and more blades with the distance."},
    {&BezierCulling::occlusion, &BezierCounts::occlusion, "occlusion", "Hidden",
     "Leaves out blades behind other things."},
};

/// The choice of a view, a check box for each test with its count, and the sums. Runs the actions named above.
void drawGrassView(PanelContext& context);

}  // namespace windloom::editor
