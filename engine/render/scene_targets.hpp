#pragma once
// Where a frame is drawn before it becomes a picture: the scene's light and, over the same depth, the
// overlays in picture colours.

#include "engine/core/result.hpp"
#include "engine/gpu/handle.hpp"
#include "engine/gpu/texture.hpp"

namespace windloom {

class SceneTargets {
 public:
  SceneTargets() = default;

  /// `samples` 1 or 4. Fails with Machine.
  static Result<SceneTargets> create(glm::ivec2 size, int samples);

  [[nodiscard]] glm::ivec2 size() const { return m_size; }
  [[nodiscard]] int samples() const { return m_samples; }
  [[nodiscard]] unsigned scene() const { return m_scene.name(); }
  [[nodiscard]] unsigned overlay() const { return m_overlay.name(); }
  [[nodiscard]] const gpu::Texture& light() const { return m_light; }
  [[nodiscard]] const gpu::Texture& overlayColour() const { return m_overlayColour; }

  void clearScene() const;    ///< depth only: sky and ground cover every pixel
  void clearOverlay() const;  ///< transparent

 private:
  gpu::Texture m_light, m_overlayColour, m_depth;
  gpu::Handle<gpu::FramebufferKind> m_scene, m_overlay;
  glm::ivec2 m_size{0};
  int m_samples = 1;
};

}  // namespace windloom
