#include "editor/widgets/look.hpp"

#include <cstdlib>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

namespace windloom::editor {

namespace {

constexpr float kTextPixels = 15.0f;

ImVec4 rgb(unsigned hex, float alpha = 1.0f) {
  return {float(hex >> 16 & 255) / 255.0f, float(hex >> 8 & 255) / 255.0f, float(hex & 255) / 255.0f, alpha};
}

Palette darkPalette() {
  Palette p;
  p.accent = rgb(0x4fb3a5);
  p.accentDim = rgb(0x2c5f59);
  p.text = rgb(0xe3e6e8);
  p.muted = rgb(0x9aa3a9);
  p.warning = rgb(0xe5b45a);
  p.error = rgb(0xf07e6e);
  p.good = rgb(0x7fc98a);
  p.axisX = rgb(0xe8705f);
  p.axisY = rgb(0x8fc95f);
  p.axisZ = rgb(0x6aa5f0);
  p.panel = rgb(0x24282b);
  p.panelHeader = rgb(0x1c1f22);
  p.border = rgb(0x121416);
  p.overlayBack = rgb(0x14181a, 0.72f);
  p.overlayText = rgb(0xf2f4f5);
  return p;
}

Palette lightPalette() {
  Palette p;
  p.accent = rgb(0x0f7a6c);
  p.accentDim = rgb(0xa9d6ce);
  p.text = rgb(0x1d2326);
  p.muted = rgb(0x56626a);
  p.warning = rgb(0x8a5a00);
  p.error = rgb(0xb3261e);
  p.good = rgb(0x1f7a36);
  p.axisX = rgb(0xb53a2b);
  p.axisY = rgb(0x3f7d1e);
  p.axisZ = rgb(0x1f5fb5);
  p.panel = rgb(0xeef0f1);
  p.panelHeader = rgb(0xdfe3e5);
  p.border = rgb(0xb7bfc4);
  p.overlayBack = rgb(0xffffff, 0.80f);
  p.overlayText = rgb(0x161b1e);
  return p;
}

/// ImGuiStyle's colours from the palette; `lift` is the colour that fields stand out with.
void setColours(ImGuiStyle& style, const Palette& p, const ImVec4& field, const ImVec4& button, const ImVec4& hover) {
  const auto set = [&](std::initializer_list<ImGuiCol_> which, const ImVec4& colour) {
    for (const ImGuiCol_ index : which) style.Colors[index] = colour;
  };
  const ImVec4 none{0, 0, 0, 0};
  set({ImGuiCol_Text}, p.text);
  set({ImGuiCol_TextDisabled}, p.muted);
  set({ImGuiCol_WindowBg, ImGuiCol_PopupBg}, p.panel);
  set({ImGuiCol_ChildBg, ImGuiCol_BorderShadow, ImGuiCol_TableRowBg, ImGuiCol_ScrollbarBg}, none);
  set({ImGuiCol_MenuBarBg, ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed}, p.panelHeader);
  set({ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_TableBorderLight, ImGuiCol_TableBorderStrong}, p.border);
  set({ImGuiCol_FrameBg}, field);
  set({ImGuiCol_Button, ImGuiCol_ScrollbarGrab, ImGuiCol_TableHeaderBg}, button);
  set({ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_ButtonHovered, ImGuiCol_ScrollbarGrabHovered,
       ImGuiCol_ScrollbarGrabActive},
      hover);
  set({ImGuiCol_ButtonActive, ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive, ImGuiCol_TextSelectedBg},
      p.accentDim);
  set({ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_SeparatorHovered,
       ImGuiCol_SeparatorActive, ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive, ImGuiCol_PlotLines,
       ImGuiCol_PlotHistogram, ImGuiCol_NavHighlight},
      p.accent);
  set({ImGuiCol_Tab, ImGuiCol_TabUnfocused}, none);
  set({ImGuiCol_TabHovered, ImGuiCol_ResizeGrip}, hover);
  set({ImGuiCol_TabActive, ImGuiCol_TabUnfocusedActive}, p.accentDim);
  set({ImGuiCol_TableRowBgAlt}, {p.text.x, p.text.y, p.text.z, 0.03f});
  set({ImGuiCol_ModalWindowDimBg}, {0, 0, 0, 0.45f});
}

/// The first of `names` under the folders where systems keep fonts; empty where there is none.
std::string findFont(std::initializer_list<const char*> names) {
  std::vector<std::filesystem::path> roots;
  if (const char* home = std::getenv("HOME")) {
    roots.emplace_back(std::filesystem::path(home) / ".local/share/fonts");
    roots.emplace_back(std::filesystem::path(home) / ".fonts");
  }
  roots.emplace_back("/usr/local/share/fonts");
  roots.emplace_back("/usr/share/fonts");
  for (const char* name : names)
    for (const auto& root : roots)
      for (const char* folder :
           {"", "opentype/inter", "truetype/inter", "inter", "truetype/fork-awesome", "fork-awesome", "truetype/dejavu",
            "dejavu", "TTF", "truetype/liberation", "truetype/noto"}) {
        std::error_code ignored;
        const auto path = root / folder / name;
        if (std::filesystem::is_regular_file(path, ignored)) return path.string();
      }
  return {};
}

/// A sans serif at `pixels` with the icons merged in.
ImFont* addFont(const std::string& file, const std::string& iconFile, float pixels, const ImWchar* iconRange) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  // Latin, general punctuation (dashes, dots), superscripts, and the few signs that units and labels use.
  static constexpr ImWchar kText[] = {0x20,   0x17f,  0x2010, 0x2027, 0x2030, 0x203a, 0x2070, 0x209c, 0x2190, 0x2193,
                                      0x2212, 0x2212, 0x2248, 0x2248, 0x2264, 0x2265, 0xd7,   0xd7,   0};
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = true;
  ImFont* font = nullptr;
  if (!file.empty()) font = atlas.AddFontFromFileTTF(file.c_str(), pixels, &config, kText);
  if (!font) {
    config.SizePixels = pixels;
    font = atlas.AddFontDefault(&config);
  }
  if (!iconFile.empty()) {
    ImFontConfig merged;
    merged.MergeMode = true;
    merged.OversampleH = 1;
    merged.GlyphMinAdvanceX = pixels * 1.15f;
    merged.GlyphOffset.y = pixels * 0.06f;
    merged.PixelSnapH = true;
    atlas.AddFontFromFileTTF(iconFile.c_str(), pixels * 0.95f, &merged, iconRange);
  }
  return font;
}

}  // namespace

void applyTheme(Look& look) {
  const bool dark = look.theme == Theme::Dark;
  look.palette = dark ? darkPalette() : lightPalette();
  ImGuiStyle style;
  style.WindowPadding = {8, 8};
  style.FramePadding = {7, 4};
  style.ItemSpacing = {7, 5};
  style.ItemInnerSpacing = {6, 4};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 12;
  style.GrabMinSize = 10;
  style.WindowRounding = 0;
  style.PopupRounding = 4;
  style.FrameRounding = 3;
  style.TabRounding = 3;
  style.ScrollbarRounding = 6;
  style.WindowBorderSize = 1;
  style.ScaleAllSizes(look.scale);
  style.WindowBorderSize = 1;
  if (dark)
    setColours(style, look.palette, rgb(0x17191b), rgb(0x363c40), rgb(0x454c51));
  else
    setColours(style, look.palette, rgb(0xffffff), rgb(0xd3d9dc), rgb(0xc2cbcf));
  ImGui::GetStyle() = style;
}

void loadFonts(Look& look) {
  // Only the icons in icons.hpp are rasterised: the whole font would double the time to the first frame.
  static constexpr ImWchar kIcons[] = {
      0xf00a, 0xf00a, 0xf015, 0xf016, 0xf01e, 0xf028, 0xf039, 0xf039, 0xf047, 0xf04c, 0xf051, 0xf051, 0xf057,
      0xf05b, 0xf064, 0xf065, 0xf069, 0xf069, 0xf06c, 0xf071, 0xf079, 0xf07c, 0xf09c, 0xf09c, 0xf0ac, 0xf0ac,
      0xf0b2, 0xf0b2, 0xf0c7, 0xf0c8, 0xf0e2, 0xf0e4, 0xf111, 0xf111, 0xf126, 0xf126, 0xf12d, 0xf12d, 0xf148,
      0xf148, 0xf178, 0xf178, 0xf18c, 0xf18c, 0xf192, 0xf192, 0xf1b2, 0xf1b2, 0xf1bb, 0xf1bb, 0xf1ce, 0xf1ce,
      0xf1e3, 0xf1e3, 0xf1fc, 0xf1fc, 0xf204, 0xf204, 0xf219, 0xf219, 0xf245, 0xf245, 0};
  ImGui::GetIO().Fonts->Clear();
  const std::string text = findFont({"Inter-Regular.otf", "Inter-Regular.ttf", "DejaVuSans.ttf",
                                     "LiberationSans-Regular.ttf", "NotoSans-Regular.ttf"});
  const std::string strong = findFont({"Inter-SemiBold.otf", "Inter-SemiBold.ttf", "DejaVuSans-Bold.ttf",
                                       "LiberationSans-Bold.ttf", "NotoSans-Bold.ttf"});
  const std::string iconFile = findFont({"forkawesome-webfont.ttf"});
  look.hasIcons = !iconFile.empty();
  const float pixels = kTextPixels * look.scale;
  look.text = addFont(text, iconFile, pixels, kIcons);
  look.strong = addFont(strong, {}, pixels, kIcons);
  look.small = addFont(text, {}, kTextPixels * 0.87f * look.scale, kIcons);
  ImGui::GetIO().FontDefault = look.text;
}

}  // namespace windloom::editor
