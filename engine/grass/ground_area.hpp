#pragma once
// The ground as something that Bezier grass grows on: the field (part 0) and a ragged margin around it (part 1).

#include <memory>
#include <vector>

#include "engine/core/thread_pool.hpp"
#include "engine/grass/growth_area.hpp"
#include "engine/model/project.hpp"

namespace windloom {

class GroundArea final : public GrowthArea {
 public:
  /// `blades`: how many will be placed at most; the ground is cut into cells accordingly.
  GroundArea(const Project& project, double blades, ThreadPool& pool);

  [[nodiscard]] int parts() const override { return 2; }
  [[nodiscard]] double area(int part) const override { return m_parts[part].area; }
  [[nodiscard]] GrowthPoint at(int part, double along, RandomStream& random) const override;
  [[nodiscard]] bool holdsTufts() const override { return true; }
  [[nodiscard]] std::optional<GrowthPoint> beside(int part, const GrowthPoint& from, glm::vec3 offset,
                                                  RandomStream& random) const override;

 private:
  struct Cell {
    glm::vec2 low{0.0f}, size{0.0f};  // m
    float most = 1.0f;                // upper bound of Growth::weight in it, nearly always; 0: it is 1 everywhere
  };
  struct Part {
    std::vector<Cell> cells;
    std::vector<double> sums;  // of the areas up to and with each cell
    double area = 0;
  };
  struct Growth {
    float grown = 1.0f;   // part of the blades, 0..1
    float weight = 1.0f;  // times m^2 of ground over a level m^2
    float height = 0.0f;  // m
    glm::vec3 normal{0.0f, 1.0f, 0.0f};
  };

  void cut(double cells);
  double measure(Cell& cell, int part) const;
  [[nodiscard]] Growth growthAt(glm::vec2 place, int part) const;
  [[nodiscard]] GrowthPoint pointAt(glm::vec2 place, const Growth& growth, int part) const;
  [[nodiscard]] float margin(glm::vec2 place) const;
  [[nodiscard]] bool within(glm::vec2 place, int part) const;
  [[nodiscard]] bool even(int part) const;

  Shared<FieldSettings> m_field;
  Shared<GrassSettings> m_grass;
  std::shared_ptr<const HeightField> m_heights;
  glm::vec2 m_low, m_high;  // of the field
  float m_steep, m_gentle;  // normal.y where nothing, where all grows
  std::uint32_t m_seed;
  Part m_parts[2];
};

}  // namespace windloom
