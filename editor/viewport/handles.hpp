#pragma once
// Points, probes and obstacle centres as handles of fixed screen size, rings around what is selected, and what the
// active tool wants shown.

#include "editor/viewport/instruments.hpp"

namespace windloom::editor {

/// Handles of everything visible. `withArrows` also draws arrows and outlines, for when the scene doesn't.
void drawHandles(const ViewArea& area, const Workspace& workspace, bool withArrows);

/// The tool's preview: lines, discs, arrows, box, labels.
void drawPreview(const ViewArea& area, const Workspace& workspace, const PreviewShapes& shapes);

}  // namespace windloom::editor
