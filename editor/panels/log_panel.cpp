#include "editor/panels/log_panel.hpp"

#include "editor/widgets/icons.hpp"
#include "editor/widgets/look.hpp"

namespace windloom::editor {

namespace {
constexpr std::size_t kMaxLines = 2000;
}

LogPanel::LogPanel(LogFile& file) {
  setLogSink([this, &file](LogLevel level, std::string_view text) {
    file.add(level, text);
    add(level, text);
  });
}

LogPanel::~LogPanel() {
  setLogSink({});
}

void LogPanel::add(LogLevel level, std::string_view text) {
  const std::lock_guard lock(m_mutex);
  m_lines.push_back({level, std::string(text)});
  if (m_lines.size() > kMaxLines) m_lines.pop_front();
  m_newLines = true;
  if (level != LogLevel::Info) ++m_unread;
}

std::string LogPanel::allText() const {
  std::string text;
  for (const Line& line : m_lines) text += line.text + "\n";
  return text;
}

void LogPanel::draw() {
  const std::lock_guard lock(m_mutex);
  m_unread = 0;
  if (ImGui::SmallButton("Copy")) ImGui::SetClipboardText(allText().c_str());
  ImGui::SameLine();
  if (ImGui::SmallButton("Clear")) m_lines.clear();
  ImGui::BeginChild("lines");
  for (const Line& line : m_lines) {
    const Palette& palette = look().palette;
    const bool plain = line.level == LogLevel::Info;
    const ImVec4& colour = plain ? palette.text : line.level == LogLevel::Warning ? palette.warning : palette.error;
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextWrapped("%s%s", plain ? "" : icons::icon(icons::kWarning, "!"),
                       plain ? line.text.c_str() : (" " + line.text).c_str());
    ImGui::PopStyleColor();
  }
  if (m_newLines) ImGui::SetScrollHereY(1.0f);
  m_newLines = false;
  ImGui::EndChild();
}

}  // namespace windloom::editor
