#pragma once
// Textures with immutable storage. To resize, make a new one.

#include <cstddef>
#include <glm/glm.hpp>
#include <string_view>

#include "engine/core/result.hpp"
#include "engine/gpu/handle.hpp"
#include "engine/gpu/memory.hpp"

namespace windloom::gpu {

enum class Filter { Nearest, Linear, Trilinear };  ///< Trilinear: linear with mipmaps
enum class Wrap { Clamp, Repeat, Border };         ///< Border: zero outside

struct TextureOptions {
  int levels = 1;  ///< mipmap levels; 0: all down to 1 x 1
  Filter filter = Filter::Linear;
  Wrap wrap = Wrap::Clamp;
  float anisotropy = 1.0f;  ///< limited to what the driver can
};

class Texture {
 public:
  Texture() = default;

  /// `format` is a sized internal format such as GL_RG32F. All creators fail with Machine where the size is
  /// over the driver's limit or there is no memory. Contents start undefined.
  static Result<Texture> create2D(std::string_view label, glm::ivec2 size, GLenum format,
                                  const TextureOptions& options = {});
  static Result<Texture> createMultisampled(std::string_view label, glm::ivec2 size, GLenum format, int samples);
  static Result<Texture> createArray(std::string_view label, glm::ivec2 size, int layers, GLenum format,
                                     const TextureOptions& options = {});
  static Result<Texture> create3D(std::string_view label, glm::ivec3 size, GLenum format,
                                  const TextureOptions& options = {});

  [[nodiscard]] GLuint name() const { return m_handle.name(); }
  [[nodiscard]] GLenum target() const { return m_target; }
  [[nodiscard]] GLenum format() const { return m_format; }
  [[nodiscard]] glm::ivec3 size() const { return m_size; }  ///< z: layers or depth, 1 for 2D
  [[nodiscard]] int levels() const { return m_levels; }
  /// Of all levels, layers and samples, by the sizes that the driver gave the channels.
  [[nodiscard]] std::size_t bytes() const;

  /// Fills one level (all layers) from tightly packed rows; `pixelFormat` and `pixelType` as GL_RG, GL_FLOAT.
  void upload(GLenum pixelFormat, GLenum pixelType, const void* data, int level = 0);
  /// As upload, one layer of an array or slice of a volume.
  void uploadLayer(int layer, GLenum pixelFormat, GLenum pixelType, const void* data, int level = 0);
  /// Makes the smaller levels from level 0.
  void generateMipmaps();
  /// Fills level 0 with zeros.
  void clear();
  /// Level 0 into tightly packed rows; waits for the GPU: for tests and exports only. Issues the barrier
  /// for image stores itself.
  void read(GLenum pixelFormat, GLenum pixelType, void* data, std::size_t bytes) const;

  /// For sampling in shaders.
  void bind(unsigned unit) const;
  /// For imageLoad/imageStore; `access` is GL_READ_ONLY, GL_WRITE_ONLY or GL_READ_WRITE.
  void bindImage(unsigned unit, GLenum access, int level = 0) const;

 private:
  static Result<Texture> finish(std::string_view label, Texture texture, const TextureOptions& options);
  Handle<TextureKind> m_handle;
  MemoryUse m_memory;
  GLenum m_target = 0, m_format = 0;
  glm::ivec3 m_size{0};
  int m_levels = 0;
};

}  // namespace windloom::gpu
