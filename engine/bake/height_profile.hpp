#pragma once
// How the wind, which is computed in a plane, goes on with height: the logarithmic law over rough ground.

namespace windloom {

struct HeightProfile {
  int layers = 8;           ///< of volumes, evenly spaced from the ground up; 1: flat, as the field is
  float top = 8.0f;         ///< m: height of a volume; > 0
  float reference = 2.0f;   ///< m: where the wind is as the field says; > 0
  float roughness = 0.03f;  ///< m: roughness length z0 of the ground (0.03: grass, 0.1: crops, 1: forest); > 0

  /// Part of the field's wind that blows at `height` m over the ground: ln(1 + h / z0) / ln(1 + reference / z0); 0 at
  /// and below the ground, 1 at the reference height. (The law of the wall, shifted by z0 so that it begins at 0.)
  [[nodiscard]] float at(float height) const;
  /// Height in m of the middle of layer `n`, counted from the ground.
  [[nodiscard]] float heightOf(int n) const;
};

}  // namespace windloom
