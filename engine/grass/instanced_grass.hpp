#pragma once
// Instanced grass after Choi & Sung, "CWD-Sim", 2024: every blade follows the wind of its group, found on
// the GPU; nothing per blade is stored or crosses the bus. Beyond the paper: tiles and blades are culled against the
// frustum and against hills and solids, blades thin out and widen with distance, and there are three levels of detail.
//
// Passes: cull_tiles looks at the tiles around the camera, scan_groups and list_chunks list their visible blades in
// chunks of 8, near ones first and always in the same order, place_blades makes the blades, three indirect draws draw
// the chunks as instances. No result is waited for.

#include <array>
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
  enum class Chains { None, Some };
  /// None: others draw them, all of them. Shells: as shells, which turn into the ground's shading far away.
  enum class Blades { None, Shells, Drawn };

  /// Fails with Machine.
  static Result<InstancedGrass> create(gpu::ShaderLibrary& shaders);

  /// Takes over field, grass settings and ground (null: flat). Where the GPU has no memory (Machine) the grass stays as
  /// it was.
  Status configure(const FieldSettings& field, const GrassSettings& grass, const HeightField* ground);

  /// Fills the settings block for this frame; it stays bound for all passes of the frame, also the ground's. Makes room
  /// for what may be seen; fails with Machine, and then nothing is drawn. `occluderLevels`: of the pyramid bound at
  /// RENDER_TEXTURE_OCCLUDERS, 0: none. `chains`: whether blades may lean otherwise than their bend.
  /// `blades`: where not Drawn, only others need the settings.
  Status bindSettings(const GrassSettings& grass, std::span<const Species> species, const GrassQuality& quality,
                      const shared::FrameBlock& frame, int occluderLevels, Chains chains, Blades blades);

  /// Culls and places. What GrassDynamics and the colliders bind, the frame block, wind, noise, ground, solid and
  /// occluder textures must be bound (render_bindings.h).
  void prepare();

  /// Draws into the target of `state`.
  void draw(const gpu::PassState& state);

  [[nodiscard]] const GrassLayout& layout() const { return m_layout; }
  /// Blades drawn in a recent finished frame.
  long long bladesDrawn();

 private:
  InstancedGrass() = default;
  Status setBounds(const GrassLayout& layout, const HeightField* ground);
  Status makeRoomFor(const GrassBlock& block, const GrassQuality& quality, bool chains);

  GrassLayout m_layout;
  gpu::Program *m_cull = nullptr, *m_scan = nullptr, *m_list = nullptr, *m_place = nullptr, *m_placePlain = nullptr;
  std::array<gpu::Program*, GRASS_LEVELS> m_blade{}, m_bladeQuick{};
  std::array<gpu::Buffer, GRASS_LEVELS> m_indices;
  std::array<gpu::VertexArray, GRASS_LEVELS> m_strips;
  gpu::Buffer m_settings, m_chunks, m_blades, m_commands, m_bounds, m_tileWork, m_groupWork, m_chains;
  gpu::ReadbackRing m_counts;
  std::uint32_t m_tiles = 0;  // looked at this frame; 0: nothing to draw
  std::uint32_t m_chunkLimit = 0;
  bool m_chained = false, m_quick = false;
  long long m_bladesDrawn = 0;
};

}  // namespace windloom
