#pragma once
// Sky and ground.

#include <array>

#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "engine/render/view_camera.hpp"

namespace windloom {

class Backdrop {
 public:
  /// Fails with Machine.
  static Result<Backdrop> create(gpu::ShaderLibrary& shaders);

  /// Draws clouds and ridges into their map once. Frame block and noise must be bound.
  void bakeSky();
  /// Full detail samples the ground's finest texture too; a software renderer goes without. Plain is quick where there
  /// are neither maps of the grass nor colliders.
  enum class GroundDetail { Full, Quick, Plain };
  void drawGround(const gpu::PassState& state, const ViewCamera& camera, GroundDetail detail) const;
  void drawSky(const gpu::PassState& state) const;

 private:
  Backdrop() = default;
  gpu::Program* m_bake = nullptr;
  gpu::Program* m_sky = nullptr;
  std::array<gpu::Program*, 3> m_ground{};  // by GroundDetail
  gpu::Texture m_skyMap;
  gpu::Handle<gpu::FramebufferKind> m_skyTarget;
  gpu::VertexArray m_noVertices;
  bool m_baked = false;
};

}  // namespace windloom
