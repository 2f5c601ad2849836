#pragma once
// The blades of a shell texture before they are cut: where in the tile they stand and what they are like. Pure.

#include <span>
#include <vector>

#include "engine/model/project.hpp"

namespace windloom {

struct ShellBlade {
  glm::vec2 root{0.0f};            ///< m, 0..side of the tile
  glm::vec2 along{1.0f, 0.0f};     ///< unit vector of the cut's long axis
  glm::vec2 radii{0.0f};           ///< m: half axes of the cut at the root, the long one first
  float height = 0;                ///< m
  std::uint8_t rank = 0, own = 0;  ///< ShellLevel::form
  float rootLight = 0;             ///< brightness of the root over that of the upper part
  glm::vec3 colour{0.0f};          ///< linear, of the upper part
};

struct ShellBlades {
  std::vector<ShellBlade> blades;
  float tallestM = 0;  ///< that any blade of the settings may have
};

/// At least one. Not more than fit: where the settings ask for more than 400,000 they are fewer and wider, and where
/// they would cover the ground 24 times they are fewer. `texelM`: cuts are 1.2 texels across at least; what that adds
/// to their area is taken from their length, then from their number.
ShellBlades growShellBlades(const GrassSettings& grass, const ShellSettings& shell, std::span<const Species> species,
                            float texelM);

}  // namespace windloom
