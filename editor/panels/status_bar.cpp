#include "editor/panels/status_bar.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "editor/widgets/icons.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {

namespace {

constexpr double kMessageSeconds = 8;

std::string grouped(long long number) {
  const std::string digits = std::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ' ';
    text += digits[i];
  }
  return text;
}

/// Small parts with more digits: a good residual is some hundredths of a percent.
std::string percent(double part) {
  return fixed(part * 100, part < 0.01 ? 3 : 1) + "%";
}

std::string millions(long long blades) {
  if (blades < 100'000) return grouped(blades);
  return fixed(double(blades) / 1e6, 2) + " M";
}

std::string sizeText(glm::ivec2 size) {
  return std::to_string(size.x) + " x " + std::to_string(size.y);
}

/// As many whole words as fit, with dots where some are left out.
std::string fitted(const std::string& text, float width) {
  if (ImGui::CalcTextSize(text.c_str()).x <= width) return text;
  std::string kept = text;
  for (std::size_t space; (space = kept.find_last_of(' ')) != std::string::npos;) {
    kept.resize(space);
    while (!kept.empty() && (kept.back() == ',' || kept.back() == ';')) kept.pop_back();
    if (ImGui::CalcTextSize((kept + " ...").c_str()).x <= width) break;
  }
  return kept + " ...";
}

struct Item {
  std::string name, text, help;
  bool failed = false;
};

std::vector<Item> machineItems(const PanelContext& context) {
  std::vector<Item> items;
  const FrameFacts& facts = context.facts;
  if (context.session) {
    const SessionStatus& status = context.session->status();
    const bool coarse = status.liveResolution != status.projectResolution;
    std::string grid = std::string(status.backend == Backend::Gpu ? "GPU " : "CPU ") + sizeText(status.liveResolution);
    if (coarse) grid += " live (project " + sizeText(status.projectResolution) + ")";
    items.push_back({"grid", grid,
                     coarse
                         ? "The live view runs on a coarser grid to hold real time; sample and bake use the project's."
                         : "The wind runs on the project's grid."});
    items.push_back({"solver", std::string("solver ") + fixed(status.stepMs, 1) + " ms",
                     std::string("Time of a solver step; fastest air ") + fixed(status.wind.maxSpeed, 1) + " m/s, " +
                         fixed(status.wind.cfl, 1) + " cells a step. The Solver tab at the bottom tells more."});
    if (status.wind.divergenceBefore > 0)
      items.push_back({"residual", "residual " + percent(status.wind.divergenceAfter / status.wind.divergenceBefore),
                       "Part of the divergence that the last step's pressure solve left"});
    if (status.wind.nonFiniteCells > 0)
      items.push_back({"broken", std::to_string(status.wind.nonFiniteCells) + " cells reset",
                       "Cells that were not finite and were set back since the wind started"});
    std::string passes = std::string("Drawing the scene: ") + fixed(status.frame.gpuMs, 1) + " ms";
    for (const auto& [name, milliseconds] : status.frame.passMs)
      passes += std::string("\n") + name + " " + fixed(milliseconds, 1) + " ms";
    items.push_back(
        {"frame", std::string("frame ") + fixed(facts.frameMs, 1) + " ms, " + fixed(facts.framesPerSecond, 0) + " fps",
         passes});
    items.push_back({"blades",
                     millions(status.frame.bladesDrawn) + " / " + millions(status.frame.bladesTotal) + " blades",
                     "Grass blades drawn of those that the project asks for"});
    items.push_back(
        {"quality",
         facts.fullQuality ? "full quality" : std::string("quality ") + fixed(double(facts.quality) * 100, 0) + "%",
         "How much of the grass is drawn to keep the frame time; View > Full quality draws all of it"});
  }
  if (!facts.liveLink.empty())
    items.insert(items.begin(), {"live", facts.liveLinkFailed ? "no live link" : "live link",
                                 "Live link: " + facts.liveLink, facts.liveLinkFailed});
  // "llvmpipe (LLVM 15.0.6, 256 bits)", "NVIDIA H200/PCIe/SSE2": what comes first says which it is.
  items.insert(items.begin(), {"gpu", facts.gpu.substr(0, facts.gpu.find_first_of("(/")), facts.gpu});
  return items;
}

}  // namespace

void StatusBar::draw(PanelContext& context) {
  Workspace& workspace = context.workspace;
  if (workspace.messageNumber() != m_messageNumber) {
    m_messageNumber = workspace.messageNumber();
    m_messageAt = ImGui::GetTime();
    m_tool = workspace.tools.active().id();
  }
  const Palette& palette = look().palette;
  // With another tool in hand its hint is what matters, unless something went wrong.
  const bool outlived = workspace.message().kind == MessageKind::Info && workspace.tools.active().id() != m_tool;
  const bool fresh = ImGui::GetTime() - m_messageAt < kMessageSeconds && !workspace.message().text.empty() && !outlived;

  ImFont* const small = look().small;
  // The machine's part is laid out from the right; whole items are left out where the window is narrow.
  const float gap = scaled(12), full = ImGui::GetContentRegionAvail().x;
  std::vector<Item> items = machineItems(context);
  const auto textWidth = [small](const std::string& text) {
    return small->CalcTextSizeA(small->FontSize, 1e9f, 0, text.c_str()).x;
  };
  const auto widthOf = [&] {
    float width = 0;
    for (const Item& item : items) width += textWidth(item.text) + gap;
    return width;
  };
  while (items.size() > 1 && widthOf() > full * 0.68f) items.pop_back();
  const float left = full - widthOf() - gap;

  ImGui::PushClipRect(ImGui::GetCursorScreenPos(),
                      {ImGui::GetCursorScreenPos().x + left, ImGui::GetCursorScreenPos().y + ImGui::GetFrameHeight()},
                      true);
  if (fresh) {
    const MessageKind kind = workspace.message().kind;
    const ImVec4& colour = kind == MessageKind::Error     ? palette.error
                           : kind == MessageKind::Warning ? palette.warning
                                                          : palette.text;
    ImGui::TextColored(colour, "%s", fitted(workspace.message().text, left).c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", workspace.message().text.c_str());
  } else {
    const std::string hint = workspace.tools.hint(workspace.context());
    ImGui::TextDisabled("%s", fitted(hint, left).c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", hint.c_str());
  }
  ImGui::PopClipRect();
  markItem("status/message");
  look().map.fact("message", fresh ? workspace.message().text : "");

  float x = left + gap;
  ImGui::PushFont(small);
  for (const Item& item : items) {
    ImGui::SameLine(x + gap);
    ImGui::TextColored(item.failed ? palette.error : palette.muted, "%s", item.text.c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", item.help.c_str());
    markItem("status/" + item.name);
    look().map.fact("status." + item.name, item.text);
    look().map.fact("status." + item.name + ".help", item.help);
    x += textWidth(item.text) + gap;
  }
  ImGui::PopFont();
}

}  // namespace windloom::editor
