#pragma once
// The editor: owns everything in the order it is built up, and passes to each part what it needs.

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "editor/app/command_line.hpp"
#include "editor/app/dialogs.hpp"
#include "editor/app/live_view.hpp"
#include "editor/app/window.hpp"
#include "editor/core/autosave.hpp"
#include "editor/core/workspace.hpp"
#include "editor/panels/command_palette.hpp"
#include "editor/panels/export_panel.hpp"
#include "editor/panels/inspector_panel.hpp"
#include "editor/panels/log_panel.hpp"
#include "editor/panels/outliner.hpp"
#include "editor/panels/probe_panel.hpp"
#include "editor/panels/status_bar.hpp"
#include "editor/panels/timeline_panel.hpp"
#include "editor/viewport/viewport.hpp"

namespace windloom::editor {

class App {
 public:
  /// Opens the window. `log` must outlive it. Fails with Machine: no display, no OpenGL 4.5, no shaders.
  static Result<std::unique_ptr<App>> create(const CommandLine& line, LogFile& log);
  ~App();

  /// Until the window is closed. The exit status.
  int run();
  /// What to tell once the window is gone: why run() ended by itself. Empty: it was closed.
  [[nodiscard]] const std::string& lastWords() const { return m_lastWords; }

 private:
  /// Sizes of the areas around the viewport, px at 100%.
  struct Layout {
    float left = 220, right = 320, bottom = 215, timeline = 460;
  };

  App(const CommandLine& line, LogFile& log, std::unique_ptr<Window> window);
  void connect();          // workspace to window, dialogs, live view
  void registerActions();  // what is not the core's: play, overlays, view, help
  void registerPlayActions();
  void registerTimeActions();
  void registerSolverActions();
  void registerFileActions();
  void registerViewActions();
  void registerGrassViewActions();
  void readPreferences();
  void readOverlays();
  void writePreferences();
  void applyLook();

  [[nodiscard]] int writeKeys() const;
  void frame();
  bool tryFrame();
  void memoryEnded();
  void passKeys();
  void runAfterFields();
  void drawInterface();
  void drawAreas(PanelContext& context);
  void drawBottom(PanelContext& context, ImVec2 min, ImVec2 max);
  void drawAbout();
  void followWind();
  void drawPicture(double seconds);
  void finishScreenshot();
  void tellStart(const char* what) const;
  void openDropped();
  void tellMap(double seconds);
  void tellGrass();
  void tellHealth(double seconds);
  void giveMemoryBack();
  void heedTrouble();
  void endWithoutGpu();
  [[nodiscard]] double waitSeconds() const;
  [[nodiscard]] PanelContext panelContext();

  using Clock = std::chrono::steady_clock;
  Clock::time_point m_started = Clock::now();  // first of all, so that it counts the window's opening, too

  CommandLine m_line;
  std::filesystem::path m_preferencesFile;
  Look m_look;
  std::unique_ptr<Window> m_window;
  LogPanel m_log;
  Workspace m_workspace;
  Autosave m_autosave;
  Dialogs m_dialogs{m_workspace};
  std::unique_ptr<LiveView> m_live;
  Viewport m_viewport;

  Outliner m_outliner;
  ProbePanel m_probes;
  TimelinePanel m_timeline;
  StatusBar m_status;
  InspectorPanel m_inspector;
  ExportPanel m_export;
  CommandPalette m_palette;
  Layout m_layout;
  bool m_helpOpen = false, m_aboutOpen = false, m_lookChanged = false, m_pictureTold = false;

  Clock::time_point m_lastFrame = Clock::now();
  KeyPress m_afterFields;     // a shortcut that waits for a field to take its text
  double m_idleSeconds = 0;   // since something last happened
  double m_windBefore = 0;    // time of the wind a frame ago
  long m_opened = 0;          // projects, so far
  double m_trimAtS = 0;       // when to give memory back; 0: not asked for
  long m_memoryFailures = 0;  // of OpenGL, that were told
  int m_frames = 0;
  int m_troubledFrames = 0;     // one after the other in which memory ended
  double m_longestFrameS = 0;   // so far
  std::size_t m_heapBytes = 0;  // when last looked at
  std::string m_title, m_lastWords;
  std::optional<int> m_exit;
};

}  // namespace windloom::editor
