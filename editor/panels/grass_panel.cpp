#include "editor/panels/grass_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <optional>

#include "editor/widgets/look.hpp"

namespace windloom::editor {
namespace {

constexpr const char* kPrefix = "inspector/grass";

struct Group {
  const char* title;
  std::initializer_list<std::string_view> keys;  ///< one that ends in '/' stands for all that begin with it
};

// What is in none of them comes first, without a title.
const Group kGroups[] = {
    {"Blades", {"height", "heightVariation", "width", "clumping"}},
    {"Dynamics",
     {"deformation", "stiffness", "stiffnessVariation", "windFactor", "droop/", "restBlend", "flutter", "swing/",
      "interacting"}},
    {"Colours", {"colours/", "dryness"}},
    {"Shade", {"shadow/"}},
    {"Ground", {"slope/"}},
    {"Maps", {"maps/"}},
};

bool isIn(const Group& group, std::string_view key) {
  return std::ranges::any_of(
      group.keys, [&](std::string_view entry) { return entry.ends_with('/') ? key.starts_with(entry) : key == entry; });
}

std::optional<AssetUse> mapOf(std::string_view key) {
  if (key == "maps/density") return AssetUse::DensityMap;
  if (key == "maps/height") return AssetUse::HeightMap;
  if (key == "maps/colour") return AssetUse::ColourMap;
  return std::nullopt;
}

}  // namespace

void drawGrass(PanelContext& context, AssetChooser& assets,
               const std::function<void(const InspectorSection&, const InspectorRow&, const RowChange&)>& apply) {
  const InspectorSection section = inspect(context.project(), {InspectorKind::Grass, {}});
  const bool grows = context.project().grass->kind != GrassKind::None;
  const auto rows = [&](const char* name, auto&& wanted) {
    if (!beginRows(name)) return;
    for (const InspectorRow& row : section.rows) {
      // What the blades' swing depends on is only shown where they swing; other rows are dimmed.
      if (!wanted(row.info.key) || (grows && !row.relevant && row.info.key.starts_with("swing/"))) continue;
      if (const auto map = mapOf(row.info.key)) {
        assets.drawRow(context, row, kPrefix, {.use = *map});
      } else if (const auto change = parameterRow(row, kPrefix)) {
        apply(section, row, *change);
      }
    }
    endRows();
  };
  rows("grass", [](std::string_view key) {
    return std::ranges::none_of(kGroups, [&](const Group& group) { return isIn(group, key); });
  });
  for (const Group& group : kGroups) {
    ImGui::PushFont(look().strong);
    const bool open = ImGui::CollapsingHeader(group.title, ImGuiTreeNodeFlags_DefaultOpen);
    ImGui::PopFont();
    markItem(std::string(kPrefix) + "/group/" + group.title);
    if (open) rows(group.title, [&](std::string_view key) { return isIn(group, key); });
  }
}

}  // namespace windloom::editor
