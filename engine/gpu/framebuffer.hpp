#pragma once
// An offscreen target: one colour texture and, if wanted, depth, both perhaps multisampled.

#include <glm/glm.hpp>
#include <string_view>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/gpu/handle.hpp"
#include "engine/gpu/texture.hpp"

namespace windloom::gpu {

struct FramebufferOptions {
  GLenum colour = GL_RGBA16F;            ///< sized format; 0: none
  GLenum depth = GL_DEPTH_COMPONENT32F;  ///< sized format; 0: none
  int samples = 1;                       ///< limited to what the driver can; see samples()
};

class Framebuffer {
 public:
  Framebuffer() = default;

  /// Fails with Machine where the driver has no memory or refuses the formats.
  static Result<Framebuffer> create(std::string_view label, glm::ivec2 size, const FramebufferOptions& options = {});

  [[nodiscard]] GLuint name() const { return m_handle.name(); }
  [[nodiscard]] glm::ivec2 size() const { return m_size; }
  [[nodiscard]] int samples() const { return m_samples; }
  [[nodiscard]] const Texture& colour() const { return m_colour; }
  [[nodiscard]] const Texture& depth() const { return m_depth; }

  /// Clears and resolves cover the whole target: they switch the scissor off and the write masks on.
  void clearColour(glm::vec4 value) const;
  void clearDepth(float value) const;

  /// Averages the samples of the colour into `target` (0: the window) at `origin`, same size.
  void resolveColour(GLuint target, glm::ivec2 origin = {0, 0}) const;
  /// Resolves colour, and depth where both have it (depth formats must agree).
  void resolveTo(const Framebuffer& target) const;

  /// The colour as 8-bit RGBA, top row first; waits for the GPU: pictures and tests. Not multisampled.
  [[nodiscard]] std::vector<unsigned char> readRgba8() const;

 private:
  Handle<FramebufferKind> m_handle;
  Texture m_colour, m_depth;
  glm::ivec2 m_size{0};
  int m_samples = 1;
};

}  // namespace windloom::gpu
