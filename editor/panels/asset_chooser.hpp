#pragma once
// Choosing the files of species, colliders, surfaces and pictures: the row that shows one, and the window to browse for
// another.

#include "editor/core/asset_load.hpp"
#include "editor/core/inspector.hpp"
#include "editor/panels/panel_context.hpp"
#include "editor/widgets/file_browser.hpp"

namespace windloom::editor {

class AssetChooser {
 public:
  /// Opens the window, or says that the project has to be saved first.
  void browse(Workspace& workspace, AssetTarget target);
  /// A row of a table of parameters: the file's name, a button to browse, for pictures one to clear, and what is wrong.
  void drawRow(PanelContext& context, const InspectorRow& row, std::string_view prefix, const AssetTarget& target);
  /// The window, once a frame.
  void draw(Workspace& workspace);

 private:
  FileBrowser m_browser;
  AssetTarget m_target;
};

}  // namespace windloom::editor
