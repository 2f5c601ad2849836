#pragma once
// Flags on poles: each is a small cloth of points held together by threads. The wind at the pole, stronger the higher,
// blows on the cloth; swing and folds come by themselves.

#include <vector>

#include "maths.hpp"
#include "wind_source.hpp"

namespace game {

/// A corner of the cloth's triangles. Copied to the GPU as it is.
struct ClothVertex {
  Vec3 position, normal;
  float along, down;    ///< 0..1 from the pole to the fly, from the top to the bottom
  Vec3 colour, stripe;  ///< linear RGB
};

class Flags {
 public:
  static constexpr int kAlong = 19, kDown = 11;  ///< points of a cloth
  static constexpr int kPoints = kAlong * kDown;

  /// Puts `count` poles where the wind blows most, well apart, and lets the cloths find their way for two seconds.
  Flags(int count, const WindSource& wind);

  void step(const WindSource& wind, float dt);

  const std::vector<Vec3>& poles() const { return m_poles; }  ///< feet, m
  float poleHeight() const { return 8.5f * m_scale; }
  /// kPoints of each flag after another, rows from the top.
  const std::vector<ClothVertex>& vertices() const { return m_vertices; }
  /// Triangles of all flags.
  std::vector<unsigned> indices() const;

 private:
  struct Point {
    Vec3 now, before;
  };

  void choosePlaces(int count, const WindSource& wind);
  void hang(Vec3 pole, Vec2 wind);
  void blow(std::size_t flag, Vec2 wind, float factor, float dt);
  void holdTogether(Point* cloth) const;
  void updateVertices(std::size_t flag);
  Vec3 normalAt(const Point* cloth, int along, int down) const;

  std::vector<Vec3> m_poles;
  std::vector<Point> m_points;
  std::vector<ClothVertex> m_vertices;
  std::vector<float> m_ripple;  // rad: how far the folds have run along each flag
  Bounds m_bounds;
  float m_scale;
};

}  // namespace game
