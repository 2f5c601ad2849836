#pragma once
// Uneven ground: its textures, which every shader of a frame may read (shaders/include/ground.glsl), and its mesh.

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "engine/model/project.hpp"
#include "engine/render/backdrop.hpp"
#include "engine/render/ground_tiles.hpp"

namespace windloom {

class GroundPass {
 public:
  /// Fails with Machine.
  static Result<GroundPass> create(gpu::ShaderLibrary& shaders);

  /// Takes over the ground; null is flat. Samples that are the same as before are not uploaded again. Fails with
  /// Machine; the ground then stays as it was.
  Status configure(Shared<HeightField> heights, glm::vec3 towardsSun);

  /// Binds the textures for all passes of a frame.
  void bind() const;
  /// Uneven ground only. `frame` is what the bound frame block holds.
  void draw(const gpu::PassState& state, const FrameBlock& frame, const ViewCamera& camera,
            Backdrop::GroundDetail detail);
  [[nodiscard]] bool flat() const { return m_heights == nullptr; }

 private:
  GroundPass() = default;
  Status makeLattices();

  std::array<gpu::Program*, 3> m_programs{};  // by GroundDetail
  gpu::Texture m_heightTexture, m_lightTexture;
  gpu::Buffer m_tilesInView;
  std::array<gpu::VertexArray, GROUND_LEVELS> m_lattices;
  std::array<gpu::Buffer, GROUND_LEVELS> m_indices;
  Shared<HeightField> m_heights;
  GroundTiles m_tiles;
};

}  // namespace windloom
