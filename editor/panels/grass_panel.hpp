#pragma once
// The inspector's grass tab: the meadow's settings in groups.

#include <functional>

#include "editor/core/inspector.hpp"
#include "editor/panels/asset_chooser.hpp"
#include "editor/panels/panel_context.hpp"
#include "editor/widgets/parameter_row.hpp"

namespace windloom::editor {

using ApplyChange = std::function<void(const InspectorSection&, const InspectorRow&, const RowChange&)>;

/// `apply` takes over a change of any row but the pictures. With Bezier and shell grass their own settings follow, and
/// how to look at it or what is drawn of it.
void drawGrass(PanelContext& context, AssetChooser& assets, const ApplyChange& apply);

}  // namespace windloom::editor
