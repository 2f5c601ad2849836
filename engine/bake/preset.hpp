#pragma once
// What differs between game engines: axes, signs, units and the order of image rows. Our own frame is
// right-handed, +Y up, metres, with the field in the XZ plane and row k at z ascending.

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string_view>

namespace windloom {

enum class Preset { Generic, Unreal, Unity, UnityNegZ, Godot };

struct PresetRules {
  Preset preset = Preset::Generic;
  std::string_view name = {};  ///< as on the command line
  std::string_view help = {};
  std::string_view handedness = "right";  ///< or "left"
  std::string_view up = "+Y";             ///< the axis that points up
  std::string_view axes[2] = {"x", "z"};  ///< names there of our x and z
  float unitsPerMetre = 1.0f;             ///< 100: centimetres
  std::string_view lengthUnit = "m", speedUnit = "m/s";
  bool negateX = false;       ///< the target's first axis is -x, so image columns are reversed as well
  bool negateZ = false;       ///< the target's second axis is -z
  bool firstRowHigh = false;  ///< row 0, the top of the file, is at the high end of the target's second axis
  bool vUpwards = false;      ///< texture coordinate v is 0 at the bottom row of a file, not at the top
};

std::span<const PresetRules> presets();
const PresetRules& rulesOf(Preset preset);
/// Nothing for an unknown name.
std::optional<Preset> presetNamed(std::string_view name);

/// Corners of the field in the target's frame: `min` <= `max` on both axes, its units.
struct PresetBounds {
  glm::vec2 min, max;
};
PresetBounds boundsIn(const PresetRules& rules, glm::vec2 minCorner, glm::vec2 size);

/// The cell of our field that lies under an image's pixel.
glm::ivec2 cellOfPixel(const PresetRules& rules, glm::ivec2 pixel, glm::ivec2 resolution);

/// Our velocity (vx, vz), m/s, as the target's along `axes`, still in m/s.
glm::vec2 velocityIn(const PresetRules& rules, glm::vec2 velocity);

}  // namespace windloom
