#pragma once
// Autumn leaves: they fall, are carried, flutter, tumble, come to rest and are lifted again. No OpenGL here: the wind
// moves them, scene.cpp draws them.

#include <vector>

#include "maths.hpp"
#include "wind_source.hpp"

namespace game {

/// What drawing needs to know of a leaf. Copied to the GPU as it is.
struct LeafLook {
  Vec3 position;  ///< m
  float size;     ///< m from stem to tip; 0 hides it
  Quaternion turn;
  Vec3 colour;  ///< linear RGB
  float curl;   ///< how far it is folded along its midrib, 0..1
};

class Leaves {
 public:
  static constexpr int kKinds = 4;  ///< shapes; leaf i has shape i / (count / kKinds)

  Leaves(int count, std::uint32_t seed, const WindSource& wind);

  /// Moves all leaves on by `dt` s, at most 1/30.
  void step(const WindSource& wind, float dt);

  const std::vector<LeafLook>& looks() const { return m_looks; }
  /// One line a leaf and the mean of all on standard output: where they began, where they are, how far they came.
  void print() const;

 private:
  struct Leaf {
    Vec3 position, velocity;
    float yaw = 0, pitch = 0, roll = 0;  // rad
    Vec3 spin;                           // rad/s about pitch, yaw, roll
    float size = 0, phase = 0;
    float sluggishness = 0;  // s that it takes to follow the wind
    float grip = 0;          // m/s of wind at the ground that lifts it
    float age = 0;           // s since it came into being
    float rest = 0;          // s that it has lain still
    bool lies = false;
    Vec2 start, travelled;  // m; jumps to a new place don't count
    int jumps = 0;
    Vec3 colour;
  };

  void place(Leaf& leaf, bool fresh);
  void fly(Leaf& leaf, Vec2 wind, float dt) const;
  void lie(Leaf& leaf, Vec2 wind, float dt);
  void tumble(Leaf& leaf, float speed, float dt) const;
  LeafLook lookOf(const Leaf& leaf) const;

  std::vector<Leaf> m_leaves;
  std::vector<float> m_places, m_winds;  // kept so that a step allocates nothing
  std::vector<LeafLook> m_looks;
  Random m_random;
  Bounds m_bounds;
  float m_scale;  // the field's smaller side / 100 m: leaves and heights are larger than life on a large meadow
};

}  // namespace game
