#pragma once
// The state of the GPU backend and what its passes share. docs/solver.md names the arrays and the stages;
// shaders/shared/wind_block.h says how they lie in the buffers.

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/wind/wind_grid.hpp"
#include "engine/wind/wind_solver.hpp"
#include "shaders/shared/wind_block.h"

namespace windloom {

/// Where things lie in a velocity buffer: u, then w, rows of `stride` floats, one ghost on each side.
struct VelocityLayout {
  explicit VelocityLayout(const WindGrid& grid);
  int stride, zFaces;
  std::size_t floats;
  [[nodiscard]] std::size_t u(int i, int k) const { return index(i, k); }
  [[nodiscard]] std::size_t w(int i, int k) const { return static_cast<std::size_t>(zFaces) + index(i, k); }

 private:
  [[nodiscard]] std::size_t index(int i, int k) const {
    return static_cast<std::size_t>(k + 1) * static_cast<std::size_t>(stride) + static_cast<std::size_t>(i + 1);
  }
};

/// WIND_BORDER_OPEN and so on.
int windBorderCode(Border border);

struct GpuFields {
  WindGrid grid;
  SolverSettings solver;
  AmbientWind ambient;
  VelocityLayout layout;
  shared::WindBlock block{};

  gpu::Buffer velocity;               ///< the field that left the last step
  gpu::Buffer carried, first, moved;  ///< q; q'; q*
  gpu::Buffer control;                ///< shared::WindControl
  gpu::Buffer sums;                   ///< of work-groups
  gpu::Buffer blockBuffer;
  gpu::Buffer flags;  ///< of cells, WIND_LINK_X_LOW and so on, 16 bits each
  gpu::Buffer gustTable;
  gpu::Texture cells;  ///< cell velocity, what others read

  /// Fails with Machine where the GPU has no memory for the grid.
  static Result<GpuFields> create(const WindSetup& setup);

  /// Takes over settings and solids; `block` is complete but for what changes every step.
  void applySettings(const WindSetup& setup);
  /// Sends `block` if it differs from what the GPU has.
  void sendBlock();
  /// Binds what every pass reads.
  void bindShared() const;

  [[nodiscard]] int width() const { return grid.width; }
  [[nodiscard]] int height() const { return grid.height; }
  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  explicit GpuFields(const WindSetup& setup);
  void uploadFlags();
  void fillBlock(const WindSetup& setup);
  void fillBorders(const std::optional<WallSpeeds>& noSlip);
  shared::WindBlock m_sent{};
  int m_gustSeed = 0;
  bool m_hasGusts = false, m_hasSent = false;
};

}  // namespace windloom
