#include "editor/panels/grass_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <span>

#include "editor/panels/grass_view.hpp"
#include "editor/widgets/look.hpp"

namespace windloom::editor {
namespace {

constexpr const char *kPrefix = "inspector/grass", *kBezierPrefix = "inspector/bezier";

struct Group {
  const char* title;
  std::initializer_list<std::string_view> keys;  ///< one that ends in '/' stands for all that begin with it
};

// What is in none of them comes first, without a title.
using Groups = std::span<const Group>;
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

// Of Bezier grass; what is in none of them comes first here, too.
const Group kBezierGroups[] = {
    {"Tufts", {"tufts/"}},
    {"Blade shape", {"blade/", "narrow/"}},
    {"Standing up and gravity", {"recovery", "gravity/"}},
    {"Wind on blades", {"wind/"}},
    {"Touch", {"collision/"}},
    {"Left out", {"culling/"}},
};

std::optional<AssetUse> mapOf(std::string_view key) {
  if (key == "maps/density") return AssetUse::DensityMap;
  if (key == "maps/height") return AssetUse::HeightMap;
  if (key == "maps/colour") return AssetUse::ColourMap;
  return std::nullopt;
}

/// True where it is open.
bool header(const char* title, const char* prefix) {
  ImGui::PushFont(look().strong);
  const bool open = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
  ImGui::PopFont();
  markItem(std::string(prefix) + "/group/" + title);
  return open;
}

/// The rows that are in no group, then each group under its title; `row` draws one where `shown` is true for it.
template <class Shown, class Row>
void drawGroups(const InspectorSection& section, Groups groups, const char* prefix, Shown&& shown, Row&& row) {
  const auto rows = [&](const char* name, auto&& wanted) {
    if (!beginRows(name)) return;
    for (const InspectorRow& one : section.rows) {
      if (wanted(one.info.key) && shown(one)) row(one);
    }
    endRows();
  };
  rows(prefix, [&](std::string_view key) {
    return std::ranges::none_of(groups, [&](const Group& group) { return isIn(group, key); });
  });
  for (const Group& group : groups) {
    if (header(group.title, prefix)) rows(group.title, [&](std::string_view key) { return isIn(group, key); });
  }
}

}  // namespace

void drawGrass(PanelContext& context, AssetChooser& assets, const ApplyChange& apply) {
  const bool bezier = context.project().grass->kind == GrassKind::Bezier;
  const InspectorSection section = inspect(context.project(), {InspectorKind::Grass, {}});
  const bool grows = context.project().grass->kind != GrassKind::None;
  // What the blades' swing depends on is only shown where they swing, and nothing of it with Bezier grass; other rows
  // are dimmed.
  const auto shown = [&](const InspectorRow& row) {
    return row.relevant || !(bezier || (grows && row.info.key.starts_with("swing/")));
  };
  const auto row = [&](const InspectorRow& one) {
    if (const auto map = mapOf(one.info.key)) {
      assets.drawRow(context, one, kPrefix, {.use = *map});
    } else if (const auto change = parameterRow(one, kPrefix)) {
      apply(section, one, *change);
    }
  };
  drawGroups(section, kGroups, kPrefix, shown, row);
  if (!bezier) return;
  const InspectorSection own = inspect(context.project(), {InspectorKind::Bezier, {}});
  drawGroups(
      own, kBezierGroups, kBezierPrefix, [](const InspectorRow& one) { return one.relevant; },
      [&](const InspectorRow& one) {
        if (const auto change = parameterRow(one, kBezierPrefix)) apply(own, one, *change);
      });
  if (header("Look at the grass", kBezierPrefix)) drawGrassView(context);
}

}  // namespace windloom::editor
