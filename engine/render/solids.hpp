#pragma once
// Obstacles: drawn as stone, and mapped (distance and shadow height) for the grass and ground around them.

#include <vector>

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "engine/model/project.hpp"
#include "engine/render/frame_block.hpp"
#include "shaders/shared/solid.h"

namespace windloom {

using shared::Solid;

/// The obstacles that are drawn: hidden ones are left out. `ground` null: flat. For how high they stand see standingOf
/// (engine/model/outline.hpp).
std::vector<Solid> makeSolids(const std::vector<Obstacle>& obstacles, const HeightField* ground = nullptr);
/// The corners of the polygons among them, as Solid::level counts them.
std::vector<glm::vec2> solidCorners(const std::vector<Obstacle>& obstacles);

class SolidPass {
 public:
  /// Fails with Machine.
  static Result<SolidPass> create(gpu::ShaderLibrary& shaders);

  /// Takes over obstacles; the map is drawn anew by the next updateMap(). Fails with Machine.
  Status configure(const std::vector<Obstacle>& obstacles, const FieldSettings& field, const HeightField* ground);

  /// Draws the map where it is out of date. Frame block and ground must be bound.
  void updateMap();
  void bindMap() const;
  void draw(const gpu::PassState& state) const;
  [[nodiscard]] bool any() const { return m_count > 0; }

 private:
  SolidPass() = default;
  Status makeMap(glm::ivec2 size);
  Status makePolygons(const std::vector<Obstacle>& obstacles, const HeightField* ground);

  gpu::Program* m_draw = nullptr;
  gpu::Program* m_drawPolygons = nullptr;
  gpu::Program* m_drawMap = nullptr;
  gpu::Buffer m_solids, m_corners, m_mesh;
  gpu::Texture m_mapTexture;
  gpu::Handle<gpu::FramebufferKind> m_map;
  gpu::VertexArray m_noVertices, m_meshVertices;
  int m_count = 0, m_meshCount = 0;
  bool m_mapFresh = false;
};

}  // namespace windloom
