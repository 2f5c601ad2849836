#pragma once
// Exports the wind for a game: what, how long, how fine, with the size it will have; runs beside the window with
// progress, an estimate and Cancel, and again after edits where that is wished. The live link is switched here, too.

#include <optional>
#include <string>
#include <utility>

#include "editor/core/folder_opener.hpp"
#include "editor/core/repeat_after_edit.hpp"
#include "editor/panels/clipping_view.hpp"
#include "editor/panels/export_request.hpp"
#include "editor/panels/export_run.hpp"
#include "editor/panels/live_share.hpp"
#include "editor/panels/panel_context.hpp"

namespace windloom::editor {

class ExportPanel {
 public:
  /// Once a frame, shown or not: tells when an export ended, and begins the next one after changes.
  void poll(PanelContext& context);
  void draw(PanelContext& context);
  /// Once a frame after the session advanced: shares the wind and looks at its speeds.
  void follow(PanelContext& context);
  /// Asks for the panel to be shown.
  void show() { m_wanted = true; }
  [[nodiscard]] bool takeShow() { return std::exchange(m_wanted, false); }
  [[nodiscard]] bool running() const { return m_run.running(); }
  [[nodiscard]] const LiveShare& share() const { return m_share; }

  void readPreferences(const Preferences& preferences);
  void keepPreferences(Preferences& preferences) const;

 private:
  void drawSettings(PanelContext& context, const BakeHeader& header, const BakeRequest& request);
  void drawFolderRow(PanelContext& context);
  void drawLiveLink();
  void drawTotal(PanelContext& context, const BakeHeader& header, const BakeRequest& request);
  void drawRun(PanelContext& context, const BakeRequest& request);
  void drawProgress();
  void drawOutcome(PanelContext& context);
  void start(PanelContext& context, BakeRequest request);
  void repeat(PanelContext& context);
  [[nodiscard]] std::string folderFor(const PanelContext& context) const;

  ExportChoices m_choices;
  FreeSpace m_freeSpace;
  ClippingView m_clipping;
  LiveShare m_share;
  FolderOpener m_opener;

  ExportRun m_run;
  std::optional<ExportRun::Outcome> m_outcome;
  struct Last {
    ExportRun::Job job;
    std::filesystem::path project;
  };
  std::optional<Last> m_last;  ///< what was exported, or is being
  RepeatAfterEdit m_repeat;

  int m_ended = 0;           ///< exports of this session
  float m_footerHeight = 0;  ///< px, as drawn last
  int m_drawnFrame = -1;
  bool m_wanted = false;
};

}  // namespace windloom::editor
