#include "engine/gpu/texture.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <string>

#include "engine/gpu/memory_failure.hpp"
#include "engine/gpu/object_label.hpp"

namespace windloom::gpu {
namespace {

std::string sizeText(glm::ivec3 size) {
  return std::to_string(size.x) + " x " + std::to_string(size.y) + (size.z > 1 ? " x " + std::to_string(size.z) : "");
}

Status checkSize(std::string_view label, glm::ivec3 size, GLenum limitName, GLenum layerLimitName) {
  WL_REQUIRE(size.x > 0 && size.y > 0 && size.z > 0, "a texture has a size");
  GLint limit = 0, layerLimit = 1;
  glGetIntegerv(limitName, &limit);
  if (layerLimitName != 0) glGetIntegerv(layerLimitName, &layerLimit);
  if (size.x <= limit && size.y <= limit && size.z <= layerLimit) return Done{};
  return makeError(ErrorKind::Machine, "the texture '" + std::string(label) + "' of " + sizeText(size) +
                                           " is larger than OpenGL's limit of " + std::to_string(limit) + " here");
}

int levelCount(int wanted, glm::ivec3 size) {
  const auto longest = static_cast<unsigned>(std::max(size.x, size.y));
  const int all = static_cast<int>(std::bit_width(longest));
  return wanted <= 0 ? all : std::min(wanted, all);
}

Texture makeEmpty(GLenum target, Handle<TextureKind>& handle) {
  GLuint name = 0;
  glCreateTextures(target, 1, &name);
  handle = Handle<TextureKind>(name);
  forgetErrors();
  return {};
}

void setSampling(GLuint name, const TextureOptions& options) {
  const bool nearest = options.filter == Filter::Nearest;
  const GLint minFilter = nearest ? (options.levels == 1 ? GL_NEAREST : GL_NEAREST_MIPMAP_NEAREST)
                                  : (options.filter == Filter::Trilinear ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  const GLint wrap =
      options.wrap == Wrap::Repeat ? GL_REPEAT : (options.wrap == Wrap::Border ? GL_CLAMP_TO_BORDER : GL_CLAMP_TO_EDGE);
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, minFilter);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
  for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTextureParameteri(name, axis, wrap);
  if (options.anisotropy > 1.0f && epoxy_has_gl_extension("GL_EXT_texture_filter_anisotropic")) {
    GLfloat limit = 1.0f;
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &limit);
    glTextureParameterf(name, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::min(options.anisotropy, limit));
  }
}

/// $WINDLOOM_GL_POISON is 1: fresh textures hold what nobody would want, so that a test sees who reads before writing.
bool poisonAsked() {
  static const bool asked = [] {
    const char* text = std::getenv("WINDLOOM_GL_POISON");
    return text != nullptr && std::string_view(text) == "1";
  }();
  return asked;
}

GLint componentType(GLuint name, GLenum what) {
  GLint type = 0;
  glGetTextureLevelParameteriv(name, 0, what, &type);
  return type;
}

void poison(const Texture& texture) {
  const GLuint name = texture.name();
  const GLint red = componentType(name, GL_TEXTURE_RED_TYPE);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const GLfloat bad[] = {nan, nan, nan, nan}, odd[] = {0.7f, 0.3f, 0.9f, 0.1f};
  const GLuint big[] = {0xfeedbeef, 0xfeedbeef, 0xfeedbeef, 0xfeedbeef};
  for (int level = 0; level < texture.levels(); ++level) {
    if (componentType(name, GL_TEXTURE_DEPTH_TYPE) != GL_NONE)
      glClearTexImage(name, level, GL_DEPTH_COMPONENT, GL_FLOAT, odd);
    else if (red == GL_INT || red == GL_UNSIGNED_INT)
      glClearTexImage(name, level, GL_RGBA_INTEGER, GL_UNSIGNED_INT, big);
    else
      glClearTexImage(name, level, GL_RGBA, GL_FLOAT, red == GL_FLOAT ? bad : odd);
  }
}

}  // namespace

Result<Texture> Texture::finish(std::string_view label, Texture texture, const TextureOptions& options) {
  labelObject(TextureKind::kLabel, texture.name(), label);
  if (glGetError() != GL_NO_ERROR) {
    return memoryFailure("OpenGL can't make the texture '" + std::string(label) + "' of " + sizeText(texture.m_size) +
                         " (no memory for it, or its format is not supported)");
  }
  texture.m_memory = MemoryUse(label, texture.bytes());
  if (poisonAsked()) poison(texture);
  if (texture.m_target != GL_TEXTURE_2D_MULTISAMPLE) setSampling(texture.name(), options);
  return texture;
}

std::size_t Texture::bytes() const {
  std::size_t bits = 0;
  for (const GLenum part : {GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE,
                            GL_TEXTURE_DEPTH_SIZE, GL_TEXTURE_STENCIL_SIZE, GL_TEXTURE_SHARED_SIZE}) {
    GLint size = 0;
    glGetTextureLevelParameteriv(name(), 0, part, &size);
    bits += static_cast<std::size_t>(size);
  }
  GLint samples = 0;
  if (m_target == GL_TEXTURE_2D_MULTISAMPLE) glGetTextureLevelParameteriv(name(), 0, GL_TEXTURE_SAMPLES, &samples);
  std::size_t texels = 0;
  for (int level = 0; level < m_levels; ++level) {
    const glm::ivec3 size = glm::max(m_size >> level, 1);
    const int deep = m_target == GL_TEXTURE_3D ? size.z : m_size.z;
    texels += static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(deep);
  }
  return texels * static_cast<std::size_t>(std::max(samples, 1)) * bits / 8;
}

Result<Texture> Texture::create2D(std::string_view label, glm::ivec2 size, GLenum format,
                                  const TextureOptions& options) {
  Texture texture;
  texture.m_target = GL_TEXTURE_2D;
  texture.m_format = format;
  texture.m_size = {size, 1};
  texture.m_levels = levelCount(options.levels, texture.m_size);
  if (Status fits = checkSize(label, texture.m_size, GL_MAX_TEXTURE_SIZE, 0); !fits) return fits.error();
  makeEmpty(texture.m_target, texture.m_handle);
  glTextureStorage2D(texture.name(), texture.m_levels, format, size.x, size.y);
  return finish(label, std::move(texture), options);
}

Result<Texture> Texture::createMultisampled(std::string_view label, glm::ivec2 size, GLenum format, int samples) {
  Texture texture;
  texture.m_target = GL_TEXTURE_2D_MULTISAMPLE;
  texture.m_format = format;
  texture.m_size = {size, 1};
  texture.m_levels = 1;
  if (Status fits = checkSize(label, texture.m_size, GL_MAX_TEXTURE_SIZE, 0); !fits) return fits.error();
  makeEmpty(texture.m_target, texture.m_handle);
  glTextureStorage2DMultisample(texture.name(), samples, format, size.x, size.y, GL_TRUE);
  return finish(label, std::move(texture), {});
}

Result<Texture> Texture::createArray(std::string_view label, glm::ivec2 size, int layers, GLenum format,
                                     const TextureOptions& options) {
  Texture texture;
  texture.m_target = GL_TEXTURE_2D_ARRAY;
  texture.m_format = format;
  texture.m_size = {size, layers};
  texture.m_levels = levelCount(options.levels, texture.m_size);
  if (Status fits = checkSize(label, texture.m_size, GL_MAX_TEXTURE_SIZE, GL_MAX_ARRAY_TEXTURE_LAYERS); !fits)
    return fits.error();
  makeEmpty(texture.m_target, texture.m_handle);
  glTextureStorage3D(texture.name(), texture.m_levels, format, size.x, size.y, layers);
  return finish(label, std::move(texture), options);
}

Result<Texture> Texture::create3D(std::string_view label, glm::ivec3 size, GLenum format,
                                  const TextureOptions& options) {
  Texture texture;
  texture.m_target = GL_TEXTURE_3D;
  texture.m_format = format;
  texture.m_size = size;
  texture.m_levels = levelCount(options.levels, size);
  if (Status fits = checkSize(label, size, GL_MAX_3D_TEXTURE_SIZE, GL_MAX_3D_TEXTURE_SIZE); !fits) return fits.error();
  makeEmpty(texture.m_target, texture.m_handle);
  glTextureStorage3D(texture.name(), texture.m_levels, format, size.x, size.y, size.z);
  return finish(label, std::move(texture), options);
}

void Texture::upload(GLenum pixelFormat, GLenum pixelType, const void* data, int level) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const int width = std::max(1, m_size.x >> level), height = std::max(1, m_size.y >> level);
  if (m_target == GL_TEXTURE_2D) {
    glTextureSubImage2D(name(), level, 0, 0, width, height, pixelFormat, pixelType, data);
  } else {
    const int depth = m_target == GL_TEXTURE_3D ? std::max(1, m_size.z >> level) : m_size.z;
    glTextureSubImage3D(name(), level, 0, 0, 0, width, height, depth, pixelFormat, pixelType, data);
  }
}

void Texture::uploadLayer(int layer, GLenum pixelFormat, GLenum pixelType, const void* data, int level) {
  WL_REQUIRE(m_target != GL_TEXTURE_2D && layer >= 0 && layer < m_size.z, "the layer exists");
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage3D(name(), level, 0, 0, layer, std::max(1, m_size.x >> level), std::max(1, m_size.y >> level), 1,
                      pixelFormat, pixelType, data);
}

void Texture::generateMipmaps() {
  glGenerateTextureMipmap(name());
}

void Texture::clear() {
  // The clear value's format must match the kind of the texture's; null means zero for all of them.
  GLint kind = 0;
  glGetInternalformativ(m_target, m_format, GL_IMAGE_PIXEL_FORMAT, 1, &kind);
  const bool integer = kind == GL_RED_INTEGER || kind == GL_RG_INTEGER || kind == GL_RGBA_INTEGER;
  glClearTexImage(name(), 0, integer ? GL_RED_INTEGER : GL_RED, integer ? GL_UNSIGNED_INT : GL_FLOAT, nullptr);
}

void Texture::read(GLenum pixelFormat, GLenum pixelType, void* data, std::size_t bytes) const {
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(name(), 0, pixelFormat, pixelType, static_cast<GLsizei>(bytes), data);
}

void Texture::bind(unsigned unit) const {
  glBindTextureUnit(unit, name());
}

void Texture::bindImage(unsigned unit, GLenum access, int level) const {
  glBindImageTexture(unit, name(), level, GL_TRUE, 0, access, m_format);
}

}  // namespace windloom::gpu
