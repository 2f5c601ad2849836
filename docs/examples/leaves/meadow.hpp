#pragma once
// Sky, ground, grass and what closes the view. The wind reaches their shaders as a small texture: sampled from the wind
// source each frame, it tells any number of blades how to lean. Copy that for your game's grass.

#include "gl_objects.hpp"
#include "wind_source.hpp"

namespace game {

class Meadow {
 public:
  Meadow(const Bounds& bounds, std::uint32_t seed);

  /// Takes the wind as it blows now into the wind map.
  void update(const WindSource& wind);
  /// Binds the maps that all shaders share; the shadow mask has unit kShadowUnit.
  void bindMaps() const;

  // Each with its program in use.
  void drawSky() const;
  void drawHills() const;
  void drawWood() const;
  void drawGround() const;
  /// `share` of all blades, 0..1; any share covers the whole field.
  void drawBlades(float share) const;

  static constexpr int kWindUnit = 0, kShadowUnit = 1, kMeadowUnit = 2, kTurfUnit = 3;
  const Program sky, hills, wood, ground, blades;

 private:
  static constexpr int kMapSide = 128;  // samples of the wind along each side: a few metres a texel are plenty

  void growBlades(const Bounds& bounds, std::uint32_t seed);

  Texture m_windMap, m_meadowMap, m_turfMap;
  Buffer m_corners, m_hills, m_wood, m_blades;
  VertexArray m_noInput, m_groundInput, m_hillInput, m_woodInput, m_bladeInput;
  std::vector<float> m_places, m_winds;
  int m_hillCorners = 0, m_woodCorners = 0;
};

}  // namespace game
