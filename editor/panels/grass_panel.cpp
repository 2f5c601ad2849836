#include "editor/panels/grass_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <span>

#include "editor/panels/grass_view.hpp"
#include "editor/panels/shell_counts.hpp"
#include "editor/widgets/look.hpp"

namespace windloom::editor {
namespace {

constexpr const char *kPrefix = "inspector/grass", *kBezierPrefix = "inspector/bezier",
                     *kShellPrefix = "inspector/shell";

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

// Of shell grass.
const Group kShellGroups[] = {
    {"Shells", {"shells", "method"}},
    {"Texture", {"texture/"}},
    {"Bend", {"bend/"}},
    {"Wind", {"wind/"}},
};

std::optional<AssetUse> pictureOf(std::string_view key) {
  if (key == "texture/file") return AssetUse::ShellPicture;
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

/// All groups of a section; a row with a picture gets a button to choose one.
template <class Shown>
void drawTable(PanelContext& context, AssetChooser& assets, const ApplyChange& apply, InspectorKind kind, Groups groups,
               const char* prefix, Shown&& shown) {
  const InspectorSection section = inspect(context.project(), {kind, {}});
  drawGroups(section, groups, prefix, shown, [&](const InspectorRow& one) {
    if (const auto picture = pictureOf(one.info.key)) {
      assets.drawRow(context, one, prefix, {.use = *picture});
    } else if (const auto change = parameterRow(one, prefix)) {
      apply(section, one, *change);
    }
  });
}

}  // namespace

void drawGrass(PanelContext& context, AssetChooser& assets, const ApplyChange& apply) {
  const GrassKind kind = context.project().grass->kind;
  // What the blades' swing depends on is only shown where they swing, and with Bezier and shell grass only what means
  // something to them; other rows are dimmed.
  const bool own = kind == GrassKind::Bezier || kind == GrassKind::Shell, grows = kind != GrassKind::None;
  drawTable(context, assets, apply, InspectorKind::Grass, kGroups, kPrefix, [&](const InspectorRow& row) {
    return row.relevant || !(own || (grows && row.info.key.starts_with("swing/")));
  });
  const auto relevant = [](const InspectorRow& row) { return row.relevant; };
  if (kind == GrassKind::Bezier) {
    drawTable(context, assets, apply, InspectorKind::Bezier, kBezierGroups, kBezierPrefix, relevant);
    if (header("Look at the grass", kBezierPrefix)) drawGrassView(context);
  }
  if (kind == GrassKind::Shell) {
    drawTable(context, assets, apply, InspectorKind::Shell, kShellGroups, kShellPrefix, relevant);
    if (header("What is drawn", kShellPrefix)) drawShellCounts(context);
  }
}

}  // namespace windloom::editor
