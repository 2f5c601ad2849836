#pragma once
// The right side: what is selected, and a tab for each part of the project's settings, and the export.

#include "editor/panels/asset_chooser.hpp"
#include "editor/panels/export_panel.hpp"
#include "editor/panels/panel_context.hpp"
#include "editor/panels/terrain_panel.hpp"

namespace windloom::editor {

class InspectorPanel {
 public:
  void draw(PanelContext& context, ExportPanel& exporter);
  /// For actions that begin with a file.
  AssetChooser& assets() { return m_assets; }

 private:
  std::size_t m_tab = 0;
  TerrainPanel m_terrain;
  AssetChooser m_assets;
};

}  // namespace windloom::editor
