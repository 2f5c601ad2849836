#pragma once
// Grass that swings though no drawn blade remembers anything: the virtually-inertial model of Belyaev, Laevsky &
// Chukanov, 2011. One virtual blade per texel of a grid over the field is simulated (shaders/shared/segment_chain.h); a
// texture holds the moments that keep it in its shape, and drawn blades find their equilibrium under them
// (shaders/include/virtual_wind.glsl).

#include "engine/core/result.hpp"
#include "engine/gpu/buffer.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/grass/dynamics_clock.hpp"
#include "engine/grass/segment_chain.hpp"

namespace windloom {

/// Most virtual blades along a side of the grid. On a field of 100 m they then stand 0.2 m apart, closer than a blade
/// is long, so that more would not be seen; each costs 112 bytes, 29 MB at 512 x 512.
inline constexpr int kMostVirtualBlades = 512;
/// The same for software renderers, for time.
inline constexpr int kMostVirtualBladesInSoftware = 128;

/// Virtual blades along x and z for a wind of so many cells: as many, divided by the smallest whole number that keeps
/// both within `most`, so that each stands for whole cells and reads their mean.
glm::ivec2 virtualGrid(glm::ivec2 windCells, int most);

class VirtualBlades {
 public:
  /// Fails with Machine. What bind() binds is valid from here on.
  static Result<VirtualBlades> create(gpu::ShaderLibrary& shaders);

  /// Takes over the meadow's settings and the wind's grid. Another grid begins at rest in the wind of the next step. On
  /// failure (Machine) all stays as it was.
  Status configure(const GrassSettings& grass, glm::ivec2 windCells, int most = kMostVirtualBlades);

  /// Goes on by `step` in the wind that is bound now. The frame block, wind and noise must be bound
  /// (render_bindings.h); the wind as it is at the end of the step.
  void step(const DynamicsStep& step);

  /// For passes that include virtual_wind.glsl.
  void bind() const;

  [[nodiscard]] glm::ivec2 grid() const { return {m_moments.size().x, m_moments.size().y}; }
  [[nodiscard]] const gpu::Texture& moments() const { return m_moments; }  ///< RGBA16F, 2 layers: G_1 G_2, G_3 G_4
  [[nodiscard]] const ChainBlock& chain() const { return m_block; }
  [[nodiscard]] std::size_t memoryBytes() const;

 private:
  VirtualBlades() = default;
  Status makeGrid(glm::ivec2 size);

  gpu::Program* m_program = nullptr;
  ChainBlock m_block{};
  gpu::Buffer m_chain, m_state;
  gpu::Texture m_moments;
  bool m_fresh = true;  // nothing has been simulated on this grid
};

}  // namespace windloom
