#pragma once
// Draws everything: a mask of shadows on the ground first, then the sky, the meadow, and what the wind moves.

#include "camera.hpp"
#include "flags.hpp"
#include "gl_objects.hpp"
#include "leaves.hpp"
#include "meadow.hpp"
#include "picture.hpp"
#include "streaks.hpp"

namespace game {

/// What the wind moves; see the parts' headers.
struct World {
  Leaves leaves;
  Flags flags;
  Streaks streaks;

  void step(const WindSource& wind, float dt) {
    leaves.step(wind, dt);
    flags.step(wind, dt);
    streaks.step(wind, dt);
  }
};

/// What a slow machine gets less of.
struct Quality {
  float blades;  ///< share of all blades of grass, 0..1
  int samples;   ///< a pixel, for smooth edges; 1 is none
};

class Scene {
 public:
  Scene(const WindSource& wind, const World& world, std::uint32_t seed);

  /// Draws into the window's framebuffer. `time` in s moves what only trembles.
  void draw(const WindSource& wind, const World& world, const Camera& camera, double time, const Quality& quality,
            int width, int height);

 private:
  struct Pass {
    Mat4 viewProjection;
    Vec3 eye;
    float time;
  };

  void makeLeaves(const World& world);
  void makeFlags(const World& world);
  void makePoles(const World& world);
  void makeShadowMask();
  void upload(const World& world);
  void drawShadows(const World& world, const Pass& view);
  void drawBackdrop(const Pass& pass, const Mat4& toDirections);
  void drawThings(const World& world, const Pass& pass, bool shadows);
  void drawStreaks(const World& world, const Pass& pass);
  void use(const Program& program, const Pass& pass) const;
  Mat4 ontoGround() const;

  Bounds m_bounds, m_maskBounds;
  float m_scale;
  Meadow m_meadow;
  Program m_leaf, m_cloth, m_pole, m_streak, m_leafShadow, m_clothShadow, m_poleShadow;
  Picture m_picture;
  Texture m_shadowMap;
  Framebuffer m_shadowTarget;
  VertexArray m_leafInput[Leaves::kKinds], m_clothInput, m_poleInput, m_streakInput;
  Buffer m_leafShapes[Leaves::kKinds], m_leafLooks, m_clothVertices, m_clothIndices, m_poleShape, m_polePlaces,
      m_streakVertices;
  int m_leafCorners[Leaves::kKinds] = {}, m_clothCount = 0, m_poleCorners = 0;
};

}  // namespace game
