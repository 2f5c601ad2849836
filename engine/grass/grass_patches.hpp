#pragma once
// Grass that things moving through it bend: tiles that are touched become patches, whose blades remember (Belyaev,
// Laevsky & Chukanov, 2011). What is remembered of a blade is how far it is bent from the pose that it has in a block,
// so that a patch whose blades have settled looks as its block does.

#include <span>

#include "engine/core/result.hpp"
#include "engine/gpu/buffer.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/grass/dynamics_clock.hpp"
#include "engine/grass/grass_layout.hpp"
#include "engine/grass/patch_cells.hpp"

namespace windloom {

class GrassPatches {
 public:
  /// Fails with Machine. What bind() binds is valid from here on.
  static Result<GrassPatches> create(gpu::ShaderLibrary& shaders);

  /// Takes over the meadow; other tiles or another number of blades drop all patches. `tallestM`: of all blades without maps. On
  /// failure (Machine) all stays as it was.
  Status configure(const GrassSettings& grass, const GrassLayout& layout, float tallestM);

  /// Goes on by `step` with these things in the grass, as they are at its end; a jump drops all patches first. All that
  /// InstancedGrass::prepare needs must be bound, and the virtual wind (VirtualBlades::bind).
  void step(const DynamicsStep& step, std::span<const ColliderPrimitive> primitives, const HeightField* ground);

  /// For passes that include grass_patches.glsl.
  void bind() const;

  [[nodiscard]] const PatchCells& cells() const { return m_cells; }
  [[nodiscard]] std::size_t memoryBytes() const;
  [[nodiscard]] const gpu::Buffer& state() const { return m_state; }  ///< see grass_patches.glsl

 private:
  GrassPatches() = default;
  Status makeRoom(const PatchCells& cells);
  Status makePrimitiveRoom(std::size_t count);
  void upload();

  gpu::Program* m_program = nullptr;
  PatchCells m_cells;
  float m_stiffness = 1.0f, m_damping = 1.0f;
  gpu::Buffer m_patches, m_table, m_state, m_primitives;
  std::uint64_t m_sent = 0;  // generation of the table
};

}  // namespace windloom
