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
  glm::vec3 colour;  ///< of blades that it leaves out, in the view of them (bezier_cull.comp)
};
inline constexpr glm::vec3 kDrawnColour{0.25f, 0.65f, 0.25f};  ///< there, of the others
inline constexpr CullingEntry kCullingTests[] = {
    {&BezierCulling::orientation,
     &BezierCounts::orientation,
     "orientation",
     "Edge-on",
     "Leaves out blades that are seen from the side.",
     {0.95f, 0.75f, 0.10f}},
    {&BezierCulling::frustum,
     &BezierCounts::frustum,
     "frustum",
     "Out of view",
     "Leaves out blades outside the picture.",
     {0.85f, 0.20f, 0.75f}},
    {&BezierCulling::distance,
     &BezierCounts::distance,
     "distance",
     "Far away",
     "Leaves out more and more blades with the distance.",
     {0.20f, 0.45f, 0.95f}},
    {&BezierCulling::occlusion,
     &BezierCounts::occlusion,
     "occlusion",
     "Behind things",
     "Leaves out blades behind other things.",
     {0.90f, 0.15f, 0.10f}},
};

/// The choice of a view, a check box for each test with its count, and the sums. Runs the actions named above.
void drawGrassView(PanelContext& context);

}  // namespace windloom::editor
