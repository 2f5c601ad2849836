#pragma once
// What Bezier grass can grow on: places on it, evenly spread, and places beside another one. Const use from any thread.

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "engine/core/hash.hpp"

namespace windloom {

/// A stream of random numbers from a seed (PCG of O'Neill, 2014, 32 bits).
class RandomStream {
 public:
  explicit RandomStream(std::uint32_t seed) : m_state(seed) {}
  /// In [0, 1).
  float next() {
    const std::uint32_t out = pcgHash(m_state);
    m_state = m_state * 747796405u + 2891336453u;
    return hashToUnit(out);
  }

 private:
  std::uint32_t m_state;
};

struct GrowthPoint {
  glm::vec3 place{0.0f};           ///< m in the world
  glm::vec3 up{0.0f, 1.0f, 0.0f};  ///< unit vector
  float grown = 1.0f;              ///< part of the blades that grow here, above 0..1
  float lushness = 1.0f;           ///< factor of their height
  std::uint32_t cell = 0;          ///< for its area: where to go on from
  bool back = false;               ///< on the back of a triangle
};

class GrowthArea {
 public:
  virtual ~GrowthArea() = default;

  /// Parts have counts of their own and no place in common.
  [[nodiscard]] virtual int parts() const = 0;
  /// m^2 of a part, weighted with the part of the blades that grow; finite.
  [[nodiscard]] virtual double area(int part) const = 0;
  /// A place in a part with an area above 0. Even spacing of `along` (0..1) gives evenly spread places. Where blades
  /// grow thinner there are fewer places.
  [[nodiscard]] virtual GrowthPoint at(int part, double along, RandomStream& random) const = 0;
  /// False: no tufts (beside() isn't possible).
  [[nodiscard]] virtual bool holdsTufts() const = 0;
  /// The place that lies `offset` (m, in the tangent plane) beside a place of the same part; none where nothing grows,
  /// and by chance where less grows than at `from`.
  [[nodiscard]] virtual std::optional<GrowthPoint> beside(int part, const GrowthPoint& from, glm::vec3 offset,
                                                          RandomStream& random) const = 0;
};

}  // namespace windloom
