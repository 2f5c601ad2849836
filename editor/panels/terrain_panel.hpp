#pragma once
// The inspector's terrain tab: kind and file of the ground, what is being read, and where it lies.

#include <functional>

#include "editor/core/inspector.hpp"
#include "editor/panels/panel_context.hpp"
#include "editor/widgets/file_browser.hpp"
#include "editor/widgets/parameter_row.hpp"

namespace windloom::editor {

class TerrainPanel {
 public:
  /// `apply` takes over a change of any row but kind and file.
  using Apply = std::function<void(const InspectorSection&, const InspectorRow&, const RowChange&)>;
  void draw(PanelContext& context, const Apply& apply);

 private:
  void drawFile(PanelContext& context, const InspectorRow& row);
  void drawState(PanelContext& context);
  void chooseKind(PanelContext& context, TerrainKind kind);
  void browse(PanelContext& context);

  FileBrowser m_browser;
};

}  // namespace windloom::editor
