#include "editor/widgets/splitter.hpp"

#include <algorithm>

#include "editor/widgets/look.hpp"

namespace windloom::editor {

float splitterThickness() {
  return scaled(4.0f);
}

bool splitter(const char* name, bool vertical, float x, float y, float length, float sign, float min, float max,
              float home, float& size) {
  const float thick = splitterThickness();
  ImGui::SetCursorScreenPos({x, y});
  ImGui::InvisibleButton(name, vertical ? ImVec2(thick, length) : ImVec2(length, thick));
  const bool active = ImGui::IsItemActive();
  if (active || ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                              packed(look().palette.accent, active ? 1.0f : 0.6f));
  }
  if (active) size += sign * (vertical ? ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.y);
  const bool doubled = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (doubled) size = home;
  size = std::clamp(size, min, std::max(min, max));
  markItem(name);
  return doubled || ImGui::IsItemDeactivated();
}

}  // namespace windloom::editor
