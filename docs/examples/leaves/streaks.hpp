#pragma once
// Streaks of air: specks without weight that leave a fading trail, so that one sees where the wind blows. Calm air
// shows nothing.

#include <vector>

#include "maths.hpp"
#include "wind_source.hpp"

namespace game {

/// A corner of a trail's ribbon. Copied to the GPU as it is.
struct StreakVertex {
  Vec3 position;
  Vec3 ahead;     ///< direction of the trail there
  float side;     ///< -1 or 1: which edge of the ribbon
  float width;    ///< m from the middle to the edge
  float opacity;  ///< 0..1
};

class Streaks {
 public:
  Streaks(int count, std::uint32_t seed, const WindSource& wind);

  void step(const WindSource& wind, float dt);

  /// Two triangles for each piece of trail, oldest piece first.
  const std::vector<StreakVertex>& vertices() const { return m_vertices; }

 private:
  static constexpr int kPieces = 18;

  struct Speck {
    Vec3 trail[kPieces + 1];  // [0] is where it is now
    float speed[kPieces + 1] = {};
    float age = 0, life = 0;  // s
  };

  void place(Speck& speck);
  void addRibbon(const Speck& speck);

  std::vector<Speck> m_specks;
  std::vector<float> m_places, m_winds;
  std::vector<StreakVertex> m_vertices;
  Random m_random;
  Bounds m_bounds;
  float m_scale;
  float m_sinceMark = 0;  // s since the trails got their last point
};

}  // namespace game
