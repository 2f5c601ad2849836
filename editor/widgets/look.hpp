#pragma once
// How everything looks: colours, fonts, scale. One Look lives in the App; widgets and panels reach it through
// ImGui's user pointer, so it needs no global of its own.

#include <imgui.h>

#include <string>

#include "editor/core/preferences.hpp"
#include "editor/widgets/ui_map.hpp"

namespace windloom::editor {

/// Colours with a meaning; the plain ones are in ImGuiStyle.
struct Palette {
  ImVec4 accent, accentDim;           // what is chosen, what can be chosen
  ImVec4 text, muted;                 // text that matters, text that explains
  ImVec4 warning, error, good;        // log, status
  ImVec4 axisX, axisY, axisZ;         // axis sign and locks
  ImVec4 panel, panelHeader, border;  // areas
  ImVec4 overlayBack, overlayText;    // on top of the picture
};

struct Look {
  Theme theme = Theme::Dark;
  float scale = 1.0f;  ///< of everything drawn: 1 = 100%
  Palette palette;
  ImFont* text = nullptr;
  ImFont* strong = nullptr;
  ImFont* small = nullptr;
  bool hasIcons = false;
  UiMap map;

  /// The field that is being typed into; there is only ever one.
  struct Typing {
    ImGuiID field = 0;
    bool starting = false;  ///< asked for the keyboard, hasn't got it yet
    int frame = -1;         ///< when the field was last drawn
    int nextAt = -1;        ///< frame in which Tab asked for the next field
    std::string text;
  } typing;

  /// The number field that is being dragged.
  struct Dragging {
    ImGuiID field = 0;
    double start = 0, offset = 0;
    bool moved = false;
  } dragging;
};

/// The look of the current ImGui context.
inline Look& look() {
  return *static_cast<Look*>(ImGui::GetIO().UserData);
}

/// `pixels` at 100% as pixels at the current scale.
inline float scaled(float pixels) {
  return pixels * look().scale;
}

inline ImU32 packed(const ImVec4& colour, float alpha = 1.0f) {
  return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, colour.w * alpha});
}

/// Sets palette and ImGuiStyle for look.theme and look.scale.
void applyTheme(Look& look);

/// Loads the fonts at look.scale into the current context's atlas: Inter and Fork Awesome where the system has
/// them, another sans serif or ImGui's own otherwise.
void loadFonts(Look& look);

/// Names the item ImGui drew last in the map.
inline void markItem(std::string_view name) {
  if (look().map.on()) look().map.rectangle(name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

}  // namespace windloom::editor
