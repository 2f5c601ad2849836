#pragma once
// A bar between two areas that can be dragged.

namespace windloom::editor {

/// Draws the bar as a child of the current window and changes `size` (px) while it is dragged, within [min, max].
/// `vertical`: the bar stands upright and moves sideways. `sign` +1: `size` is the area before the bar, -1: behind
/// it. Double click gives `home`. True when it was changed and let go.
bool splitter(const char* name, bool vertical, float x, float y, float length, float sign, float min, float max,
              float home, float& size);

/// Thickness of the bar, px.
float splitterThickness();

}  // namespace windloom::editor
