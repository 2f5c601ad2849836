#include "editor/widgets/number_field.hpp"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/core/arithmetic.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {

namespace {

// Dragging by so many pixels at 100% is one step: slow enough to meet a value, fast enough to cross a range.
constexpr float kPixelsPerStep = 4.0f;

bool pressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

void startTyping(ImGuiID field, std::string text) {
  Look::Typing& typing = look().typing;
  typing.field = field;
  typing.starting = true;
  typing.text = std::move(text);
  typing.frame = ImGui::GetFrameCount();
}

/// Tab enters the value and goes on to the next number. ImGui's own order of fields knows only those that are being
/// typed into, so it is turned off (PushAllowKeyboardFocus).
bool leaveByTab() {
  if (!ImGui::IsItemActive() || !pressed(ImGuiKey_Tab)) return false;
  ImGui::ClearActiveID();
  look().typing.nextAt = ImGui::GetFrameCount();
  return true;
}

void drawFrame(const std::string& text, bool mixed, std::string_view unit, bool hovered, bool active) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
  const ImGuiStyle& style = ImGui::GetStyle();
  list.AddRectFilled(min, max, ImGui::GetColorU32(active || hovered ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                     style.FrameRounding);
  const ImVec2 at{min.x + style.FramePadding.x, min.y + style.FramePadding.y};
  const float textWidth = ImGui::CalcTextSize(text.c_str()).x;
  list.PushClipRect(min, max, true);
  list.AddText(at, ImGui::GetColorU32(mixed ? ImGuiCol_TextDisabled : ImGuiCol_Text), text.c_str());
  if (!unit.empty()) {
    const float width = ImGui::CalcTextSize(unit.data(), unit.data() + unit.size()).x;
    const float right = max.x - style.FramePadding.x - width;
    // Where both don't fit the number wins.
    if (right > at.x + textWidth + style.ItemInnerSpacing.x)
      list.AddText({right, at.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled), unit.data(), unit.data() + unit.size());
  }
  list.PopClipRect();
}

NumberEdit typeNumber(const NumberFormat& format) {
  Look::Typing& typing = look().typing;
  NumberEdit edit;
  typing.frame = ImGui::GetFrameCount();
  if (typing.starting) ImGui::SetKeyboardFocusHere();
  ImGui::PushAllowKeyboardFocus(false);
  const bool entered = ImGui::InputText("##typed", &typing.text,
                                        ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::PopAllowKeyboardFocus();
  if (ImGui::IsItemActive()) typing.starting = false;
  const bool left = leaveByTab();
  if (typing.starting || !(entered || left || ImGui::IsItemDeactivated())) return edit;
  typing.field = 0;
  if (pressed(ImGuiKey_Escape)) return edit;
  const Result<double> value = evaluateArithmetic(typing.text, format.unit);
  if (!value) {
    edit.problem = value.error().text();
    return edit;
  }
  edit.changed = edit.finished = true;
  edit.value = format.whole ? std::round(*value) : *value;
  return edit;
}

NumberEdit dragNumber(ImGuiID field, double value, bool mixed, const NumberFormat& format) {
  Look::Dragging& drag = look().dragging;
  const ImGuiIO& io = ImGui::GetIO();
  NumberEdit edit;
  ImGui::InvisibleButton("##drag", {ImGui::CalcItemWidth(), ImGui::GetFrameHeight()});
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  if (ImGui::IsItemActivated()) drag = {field, value, 0, false};
  if (hovered || active) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);

  const std::string shown = displayNumber(value, format.step, format.whole);
  drawFrame(mixed ? "mixed" : shown, mixed, format.unit, hovered, active);

  if (active && drag.field == field) {
    const double notch = format.step * (io.KeyCtrl && !format.whole ? 0.1 : io.KeyShift ? 10.0 : 1.0);
    drag.moved = drag.moved || ImGui::IsMouseDragging(ImGuiMouseButton_Left, scaled(3.0f));
    if (drag.moved) {
      drag.offset += double(io.MouseDelta.x) / double(scaled(kPixelsPerStep)) * notch;
      const double next = std::clamp(drag.start + std::round(drag.offset / notch) * notch, format.min, format.max);
      edit.changed = next != value || mixed;
      edit.value = next;
    }
  }
  if (ImGui::IsItemDeactivated() && drag.field == field) {
    edit.finished = drag.moved;
    if (!drag.moved) startTyping(field, mixed ? "" : shown);
    drag = {};
  }
  edit.reset = hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right);
  return edit;
}

}  // namespace

std::string displayNumber(double value, double step, bool whole) {
  if (whole) return fixed(value, 0);
  // Two digits beyond the step: what a fine drag makes stays visible.
  const int digits = std::clamp(int(std::ceil(-std::log10(std::max(step, 1e-6)))) + 2, 2, 7);
  std::string text = fixed(value, digits);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

NumberEdit numberField(const char* name, double value, bool mixed, const NumberFormat& format) {
  Look::Typing& typing = look().typing;
  ImGui::PushID(name);
  const ImGuiID field = ImGui::GetID("##number");
  if (typing.nextAt == ImGui::GetFrameCount() && typing.field == 0) {
    typing.nextAt = -1;
    startTyping(field, mixed ? "" : displayNumber(value, format.step, format.whole));
  }
  const NumberEdit edit = typing.field == field ? typeNumber(format) : dragNumber(field, value, mixed, format);
  markItem(name);
  ImGui::PopID();
  return edit;
}

bool textField(const char* name, std::string& value, const char* hint) {
  Look::Typing& typing = look().typing;
  ImGui::PushID(name);
  const ImGuiID field = ImGui::GetID("##text");
  std::string untouched = value;
  std::string& text = typing.field == field ? typing.text : untouched;
  ImGui::PushAllowKeyboardFocus(false);
  ImGui::InputTextWithHint("##text", hint, &text, ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopAllowKeyboardFocus();
  if (ImGui::IsItemActive()) {
    if (typing.field != field) typing.text = untouched;
    typing.field = field;
    typing.starting = false;
    typing.frame = ImGui::GetFrameCount();
  }
  bool entered = false;
  const bool left = leaveByTab();
  if ((left || ImGui::IsItemDeactivated()) && typing.field == field) {
    typing.field = 0;
    entered = !pressed(ImGuiKey_Escape) && text != value;
    if (entered) value = text;
  }
  markItem(name);
  ImGui::PopID();
  return entered;
}

bool typingPending() {
  const Look::Typing& typing = look().typing;
  return typing.field != 0 && typing.starting && typing.frame >= ImGui::GetFrameCount() - 1;
}

}  // namespace windloom::editor
