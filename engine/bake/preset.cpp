#include "engine/bake/preset.hpp"

#include <array>

#include "engine/core/contract.hpp"

namespace windloom {
namespace {

// Sources: Unreal's glTF exporter swaps to (x, z, y) and counts centimetres; UnityGLTF negates x, and Unity puts
// texture coordinate v = 0 at the bottom row of a file; Godot shares glTF's frame and has v = 0 at the top row.
constexpr std::array<PresetRules, 5> kPresets = {{
    {.preset = Preset::Generic,
     .name = "generic",
     .help = "our own frame: right-handed, +Y up, metres, first image row at low z"},
    {.preset = Preset::Unreal,
     .name = "unreal",
     .help = "left-handed, +Z up, centimetres; our z is its y",
     .handedness = "left",
     .up = "+Z",
     .axes = {"x", "y"},
     .unitsPerMetre = 100.0f,
     .lengthUnit = "cm",
     .speedUnit = "cm/s"},
    {.preset = Preset::Unity,
     .name = "unity",
     .help = "left-handed, +Y up, x negated, first image row at high z",
     .handedness = "left",
     .negateX = true,
     .firstRowHigh = true,
     .vUpwards = true},
    {.preset = Preset::UnityNegZ,
     .name = "unity-negz",
     .help = "as unity, for scenes whose importer negates z instead of x",
     .handedness = "left",
     .negateZ = true,
     .firstRowHigh = true,
     .vUpwards = true},
    {.preset = Preset::Godot, .name = "godot", .help = "as generic"},
}};

}  // namespace

std::span<const PresetRules> presets() {
  return kPresets;
}

const PresetRules& rulesOf(Preset preset) {
  for (const PresetRules& rules : kPresets) {
    if (rules.preset == preset) return rules;
  }
  WL_REQUIRE(false, "every preset has rules");
  return kPresets[0];
}

std::optional<Preset> presetNamed(std::string_view name) {
  for (const PresetRules& rules : kPresets) {
    if (rules.name == name) return rules.preset;
  }
  return std::nullopt;
}

PresetBounds boundsIn(const PresetRules& rules, glm::vec2 minCorner, glm::vec2 size) {
  glm::vec2 min = minCorner, max = minCorner + size;
  if (rules.negateX) {
    min.x = -(minCorner.x + size.x);
    max.x = -minCorner.x;
  }
  if (rules.negateZ) {
    min.y = -(minCorner.y + size.y);
    max.y = -minCorner.y;
  }
  return {min * rules.unitsPerMetre, max * rules.unitsPerMetre};
}

glm::ivec2 cellOfPixel(const PresetRules& rules, glm::ivec2 pixel, glm::ivec2 resolution) {
  return {rules.negateX ? resolution.x - 1 - pixel.x : pixel.x,
          rules.firstRowHigh != rules.negateZ ? resolution.y - 1 - pixel.y : pixel.y};
}

glm::vec2 velocityIn(const PresetRules& rules, glm::vec2 velocity) {
  return {rules.negateX ? -velocity.x : velocity.x, rules.negateZ ? -velocity.y : velocity.y};
}

}  // namespace windloom
