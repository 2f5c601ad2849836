#pragma once
// Instanced grass after Choi & Sung, "CWD-Sim", 2024: every blade follows the wind of its group, found on
// the GPU; nothing per blade crosses the bus. Beyond the paper: tiles are culled against the frustum, blades
// thin out and widen with distance, and there are three levels of detail.
//
// Passes: cull_tiles lists chunks of visible blades, place_blades makes each blade and puts it on the list
// of its level, three indirect draws draw the lists. No result is waited for.

#include <memory>
#include <span>

#include "engine/core/result.hpp"
#include "engine/gpu/buffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "engine/grass/grass_layout.hpp"

namespace windloom {

class InstancedGrass {
 public:
  /// Fails with Machine.
  static Result<InstancedGrass> create(gpu::ShaderLibrary& shaders);

  /// Takes over field, grass settings and ground (null: flat); equal layouts keep their buffers. Where the GPU has no memory for
  /// the lists (Machine) the grass stays as it was.
  Status configure(const FieldSettings& field, const GrassSettings& grass, const HeightField* ground);

  /// Fills the settings block for this frame; it stays bound for all passes of the frame, also the ground's.
  void bindSettings(const GrassSettings& grass, float detail);

  /// Culls and places. The frame block, wind, noise, ground and solid textures must be bound (render_bindings.h).
  void prepare();

  /// Draws into the target of `state`.
  void draw(const gpu::PassState& state);

  [[nodiscard]] const GrassLayout& layout() const { return m_layout; }
  /// Blades drawn in a recent finished frame.
  long long bladesDrawn();

 private:
  InstancedGrass() = default;
  Status setBounds(const GrassLayout& layout, const HeightField* ground);
  bool empty() const { return m_layout.chunkLimit == 0; }

  GrassLayout m_layout;
  gpu::Program* m_cull = nullptr;
  gpu::Program* m_place = nullptr;
  gpu::Program* m_blade[GRASS_LEVELS] = {};
  gpu::Buffer m_settings, m_chunks, m_blades, m_commands, m_bounds;
  gpu::VertexArray m_noVertices;
  gpu::ReadbackRing m_counts;
  long long m_bladesDrawn = 0;
};

}  // namespace windloom
