#pragma once
// Exports the wind for a game: what, how long, how fine, with the size it will have; runs beside the window on the CPU
// backend with progress, an estimate and Cancel.

#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include "editor/panels/panel_context.hpp"
#include "engine/bake/bake.hpp"

namespace windloom::editor {

class ExportPanel {
 public:
  ExportPanel();
  /// Cancels a running export and waits for it.
  ~ExportPanel();
  ExportPanel(const ExportPanel&) = delete;
  ExportPanel& operator=(const ExportPanel&) = delete;

  /// Once a frame, shown or not: tells when an export ended.
  void poll(PanelContext& context);
  void draw(PanelContext& context);
  /// Asks for the panel to be shown.
  void show() { m_wanted = true; }
  [[nodiscard]] bool takeShow() { return std::exchange(m_wanted, false); }
  [[nodiscard]] bool running() const { return m_running; }

 private:
  struct Outcome {
    bool failed = false;
    std::string text;
  };
  void drawSettings(PanelContext& context);
  void drawFormats();
  void drawSize(const PanelContext& context);
  void drawProgress();
  void start(PanelContext& context);
  void run(const Project& project, const BakeRequest& request);
  [[nodiscard]] BakeRequest request(const Project& project) const;
  [[nodiscard]] std::string folderFor(const PanelContext& context) const;

  std::string m_folder;  ///< empty: beside the project
  std::set<std::string, std::less<>> m_formats;
  Preset m_preset = Preset::Generic;
  double m_from = 2, m_seconds = 4, m_fps = 15;
  glm::ivec2 m_resolution{256, 256};
  bool m_fullResolution = false, m_loop = true;

  std::thread m_worker;
  std::atomic<bool> m_running = false, m_cancel = false, m_ended = false;
  std::atomic<double> m_part = 0;
  std::atomic<BakePhase> m_phase = BakePhase::Recording;
  std::chrono::steady_clock::time_point m_startedAt;
  std::mutex m_mutex;  // for m_outcome
  Outcome m_outcome;
  bool m_wanted = false;
};

}  // namespace windloom::editor
