#pragma once
// Where a frame is drawn before it is resolved into the picture: colours of the picture (sRGB-encoded) and depth.

#include "engine/core/result.hpp"
#include "engine/gpu/framebuffer.hpp"

namespace windloom {

class SceneTargets {
 public:
  SceneTargets() = default;

  /// `samples` 1, 2, 4 or 8: as many as the machine can. Fails with Machine.
  static Result<SceneTargets> create(glm::ivec2 size, int samples);

  [[nodiscard]] glm::ivec2 size() const { return m_scene.size(); }
  [[nodiscard]] int samples() const { return m_samples; }
  [[nodiscard]] unsigned scene() const { return m_scene.name(); }

  [[nodiscard]] const gpu::Texture& depth() const { return m_scene.depth(); }

  void clearDepth() const { m_scene.clearDepth(1.0f); }  ///< colours need none: sky and ground cover every pixel
  /// Averages the samples into `framebuffer` (any 8-bit colour format) at `origin`.
  void resolve(unsigned framebuffer, glm::ivec2 origin) const;

 private:
  gpu::Framebuffer m_scene, m_resolved;
  int m_samples = 1;  // as asked for
};

}  // namespace windloom
