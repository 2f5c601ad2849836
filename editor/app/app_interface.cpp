// The layout: areas around the viewport with bars between them.

#include <algorithm>

#include "editor/app/app.hpp"
#include "editor/app/menus.hpp"
#include "editor/panels/help_window.hpp"
#include "editor/panels/history_panel.hpp"
#include "editor/panels/solver_panel.hpp"
#include "editor/widgets/splitter.hpp"

namespace windloom::editor {

namespace {

enum class Back { Panel, Header, None };

/// A child window over a rectangle; endArea always follows.
void beginArea(const char* name, ImVec2 min, ImVec2 max, Back back) {
  const Palette& palette = look().palette;
  const ImVec4 colour = back == Back::Panel    ? palette.panel
                        : back == Back::Header ? palette.panelHeader
                                               : ImVec4(0, 0, 0, 0);
  ImGui::SetCursorScreenPos(min);
  ImGui::PushStyleColor(ImGuiCol_ChildBg, colour);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, back == Back::None ? ImVec2(0, 0) : ImVec2(scaled(8), scaled(6)));
  ImGui::BeginChild(name, {max.x - min.x, max.y - min.y}, false,
                    back == Back::None ? ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoScrollbar
                                       : ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

void endArea() {
  ImGui::EndChild();
}

/// A splitter whose size is kept at 100%.
bool scaledSplitter(const char* name, bool vertical, float x, float y, float length, float sign, float min, float max,
                    float home, float& size) {
  float pixels = scaled(size);
  const bool done = splitter(name, vertical, x, y, length, sign, min, max, scaled(home), pixels);
  size = pixels / look().scale;
  return done;
}

}  // namespace

void App::drawInterface() {
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(io.DisplaySize);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
  ImGui::Begin("windloom", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_MenuBar);
  ImGui::PopStyleVar(2);
  PanelContext context = panelContext();
  drawMenuBar(m_workspace);
  drawAreas(context);
  ImGui::End();

  m_palette.draw(m_workspace.actions);
  drawHelpWindow(m_workspace.actions, m_helpOpen);
  drawAbout();
  m_dialogs.draw();
}

void App::drawAreas(PanelContext& context) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float bar = splitterThickness();
  const float top = ImGui::GetCursorScreenPos().y;
  const float toolbar = ImGui::GetFrameHeight() + scaled(12), status = ImGui::GetFrameHeight() + scaled(4);
  const float areaTop = top + toolbar, areaBottom = display.y - status;
  const Layout home;

  // The viewport always keeps some room, whatever the window's size.
  const float sideMax = std::max(scaled(120), (display.x - std::max(scaled(240), display.x * 0.45f)) / 2);
  const float left = std::clamp(scaled(m_layout.left), scaled(120), sideMax);
  const float right = std::clamp(scaled(m_layout.right), scaled(120), sideMax);
  const float bottomMax = std::max(scaled(80), areaBottom - areaTop - scaled(160));
  const float bottom = std::clamp(scaled(m_layout.bottom), scaled(80), bottomMax);
  const float viewLeft = left + bar, viewRight = display.x - right - bar, viewBottom = areaBottom - bottom - bar;

  bool resized = scaledSplitter("split/left", true, left, areaTop, areaBottom - areaTop, 1, scaled(120), sideMax,
                                home.left, m_layout.left);
  resized |= scaledSplitter("split/right", true, viewRight, areaTop, areaBottom - areaTop, -1, scaled(120), sideMax,
                            home.right, m_layout.right);
  resized |= scaledSplitter("split/bottom", false, viewLeft, viewBottom, viewRight - viewLeft, -1, scaled(80),
                            bottomMax, home.bottom, m_layout.bottom);
  if (resized) writePreferences();

  beginArea("toolbar", {0, top}, {display.x, areaTop}, Back::Header);
  drawToolbar(context);
  endArea();
  beginArea("outliner", {0, areaTop}, {left, areaBottom}, Back::Panel);
  m_outliner.draw(context);
  endArea();
  beginArea("inspector", {viewRight + bar, areaTop}, {display.x, areaBottom}, Back::Panel);
  m_inspector.draw(context, m_export);
  endArea();
  drawBottom(context, {viewLeft, viewBottom + bar}, {viewRight, areaBottom});
  beginArea("status", {0, areaBottom}, display, Back::Header);
  m_status.draw(context);
  endArea();
  // Last: a click into the picture must find what was typed in a panel already entered.
  beginArea("view", {viewLeft, areaTop}, {viewRight, viewBottom}, Back::None);
  m_viewport.draw(m_workspace, context.session != nullptr);
  endArea();
}

void App::drawBottom(PanelContext& context, ImVec2 min, ImVec2 max) {
  const float bar = splitterThickness(), width = max.x - min.x;
  const float mostly = std::max(scaled(100), std::min(width - scaled(160), width * 0.7f));
  // The tabs beside it want to be read in full, but not for the time and its buttons.
  const float least = std::max(scaled(100), std::min(scaled(224), width * 0.6f));
  const float timeline =
      std::clamp(scaled(m_layout.timeline), scaled(100), std::max(least, std::min(mostly, width - scaled(230))));
  if (scaledSplitter("split/timeline", true, min.x + timeline, min.y, max.y - min.y, 1, scaled(100), mostly,
                     Layout{}.timeline, m_layout.timeline))
    writePreferences();
  beginArea("timeline", min, {min.x + timeline, max.y}, Back::Panel);
  m_timeline.draw(context);
  endArea();
  beginArea("notes", {min.x + timeline + bar, min.y}, max, Back::Panel);
  if (ImGui::BeginTabBar("notes")) {
    const auto tab = [](const char* label, const char* name) {
      const bool open = ImGui::BeginTabItem(label);
      markItem(std::string("notes/tab/") + name);
      return open;
    };
    if (tab("Probes", "Probes")) {
      m_probes.draw(context);
      ImGui::EndTabItem();
    }
    if (tab("Solver", "Solver")) {
      drawSolverPanel(context);
      ImGui::EndTabItem();
    }
    const std::string log = m_log.unread() > 0 ? "Log (" + std::to_string(m_log.unread()) + ")###log" : "Log###log";
    if (tab(log.c_str(), "Log")) {
      m_log.draw();
      ImGui::EndTabItem();
    }
    if (tab("History", "History")) {
      drawHistoryPanel(context);
      ImGui::EndTabItem();
    }
    ImGui::EndTabBar();
  }
  endArea();
}

void App::drawAbout() {
  if (!m_aboutOpen) return;
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  if (ImGui::Begin("About Windloom", &m_aboutOpen, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse)) {
    ImGui::PushFont(m_look.strong);
    ImGui::TextUnformatted("Windloom " WINDLOOM_VERSION);
    ImGui::PopFont();
    ImGui::TextUnformatted("Draw wind, see grass answer, export it for games.");
    ImGui::TextDisabled("MIT license. Graphics: %s", m_live->facts().gpu.c_str());
    if (ImGui::IsWindowFocused() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false))
      m_aboutOpen = false;
  }
  ImGui::End();
}

}  // namespace windloom::editor
