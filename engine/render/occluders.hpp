#pragma once
// What hills and solids hide: their depths drawn small, and a pyramid of the farthest ones (Greene, Kass & Miller,
// "Hierarchical Z-buffer visibility", 1993), for the culling of grass (shaders/include/occluders.glsl).
//
// A texel of the lowest level takes the farthest depth of its neighbours, too, so that nothing which shows beside a
// silhouette counts as hidden; only a gap narrower than a texel between two occluders can be missed.

#include <functional>

#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"

namespace windloom {

class Occluders {
 public:
  /// `size`: of the lowest level, powers of two. Fails with Machine.
  static Result<Occluders> create(gpu::ShaderLibrary& shaders, glm::ivec2 size);

  /// Draws with `drawOccluders`, which is given the state to draw in, and makes the pyramid. The frame block must be
  /// bound.
  void update(const std::function<void(const gpu::PassState&)>& drawOccluders);
  void bind() const;
  [[nodiscard]] int levels() const { return m_levels; }

 private:
  Occluders() = default;

  gpu::Program* m_reduce = nullptr;
  gpu::Framebuffer m_depths;
  gpu::Texture m_pyramid;
  glm::ivec2 m_size{0};
  int m_levels = 0;
};

}  // namespace windloom
