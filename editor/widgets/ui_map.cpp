#include "editor/widgets/ui_map.hpp"

#include <cmath>
#include <fstream>

namespace windloom::editor {

void UiMap::rectangle(std::string_view name, ImVec2 min, ImVec2 max) {
  if (!on()) return;
  const auto whole = [](float value) { return std::to_string(std::lround(value)); };
  m_rectangles.insert_or_assign(
      std::string(name), whole(min.x) + " " + whole(min.y) + " " + whole(max.x - min.x) + " " + whole(max.y - min.y));
}

void UiMap::fact(std::string_view name, std::string_view value) {
  if (!on()) return;
  std::string line;
  for (const char c : value) line += c == '\n' ? std::string("\\n") : std::string(1, c == '\t' ? ' ' : c);
  m_facts.insert_or_assign(std::string(name), std::move(line));
}

void UiMap::endFrame() {
  if (!on()) return;
  std::string text;
  for (const auto& [name, value] : m_facts) text += "fact\t" + name + "\t" + value + "\n";
  for (const auto& [name, value] : m_rectangles) text += "rect\t" + name + "\t" + value + "\n";
  m_facts.clear();
  m_rectangles.clear();
  if (text == m_written) return;
  // Renamed into place so that no reader meets half of it, but not synced to the disk: it changes every frame.
  const std::filesystem::path part = m_file.string() + ".part";
  std::ofstream(part, std::ios::binary) << text;
  std::error_code failed;
  std::filesystem::rename(part, m_file, failed);
  if (!failed) m_written = std::move(text);
}

}  // namespace windloom::editor
