#pragma once
// A recorded field at another resolution.

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/model/project.hpp"

namespace windloom {

/// Fields of one resolution to another over the same area. Along an axis that gets fewer cells each new cell is the
/// mean of the old ones under it, weighted by how much of each it covers, so the mean of the field stays; along one
/// that gets more, values are interpolated linearly between cell centres, clamped at the border or, along an axis in
/// which the field repeats, with the cell at the other end.
class Resampler {
 public:
  Resampler(glm::ivec2 from, glm::ivec2 to, glm::bvec2 wraps = {false, false});

  /// `in` has from.x * from.y values, row after row; `out` is resized.
  void apply(std::span<const glm::vec2> in, std::vector<glm::vec2>& out);

  /// What one new cell takes along one axis: `weights` from `first` on, going on at 0 behind the last.
  struct Tap {
    int first = 0;
    std::vector<float> weights;
  };
  /// Of each new column and row, for those who filter elsewhere.
  [[nodiscard]] const std::vector<Tap>& columns() const { return m_columns; }
  [[nodiscard]] const std::vector<Tap>& rows() const { return m_rows; }

 private:
  static std::vector<Tap> tapsFor(int from, int to, bool wraps);

  glm::ivec2 m_from, m_to;
  std::vector<Tap> m_columns, m_rows;
  std::vector<glm::vec2> m_narrowed;  // to.x * from.y
};

/// Along which axes a field repeats.
glm::bvec2 wrapsOf(const FieldSettings& field);

}  // namespace windloom
