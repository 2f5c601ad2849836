#pragma once
// How Bezier grass is looked at: what the editor's debug views show, which culling tests run, and what they count.

namespace windloom {

enum class GrassView {
  Normal,
  Patches,    ///< each patch in a colour of its own
  Culled,     ///< single blades that a test leaves out are drawn, too, in the colour of the test
  Strength,   ///< collision strength
  Wireframe,  ///< the triangles' edges
};

/// Tests for single blades; patches are always tested against the frustum, unless FrameQuality::culling is off.
struct BezierCulling {
  bool orientation = true;  ///< eq. 17
  bool frustum = true;      ///< eq. 18
  bool distance = true;     ///< eq. 19, 20
  bool occlusion = true;
  bool operator==(const BezierCulling&) const = default;
};

/// Of a recent finished frame. inPatches = buried + orientation + frustum + distance + occlusion + drawn; a blade
/// counts for the first test that leaves it out, in this order, but all blades of a patch that is hidden as a whole for
/// occlusion.
struct BezierCounts {
  long long blades = 0;  ///< that grow
  long long patches = 0;
  long long patchesSeen = 0;
  long long inPatches = 0;                                              ///< blades of the patches seen
  long long orientation = 0, frustum = 0, distance = 0, occlusion = 0;  ///< left out
  long long buried = 0;                                                 ///< stand in solids
  long long drawn = 0;
};

}  // namespace windloom
