#include "engine/grass/grass_maps.hpp"

#include <epoxy/gl.h>

#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

constexpr std::uint8_t kAll = 255, kMidGrey = 128;  // what changes nothing

}  // namespace

Result<GrassMaps> GrassMaps::create() {
  GrassMaps maps;
  if (Status made = maps.configure(GrassSettings{}); !made) return made.error();
  return maps;
}

Status GrassMaps::adopt(Map& map, const std::shared_ptr<const GrassMap>& pixels, const char* label,
                        std::uint8_t neutral) {
  if (map.texture.name() != 0 && pixels == map.pixels) return Done{};
  const bool there = pixels && pixels->size.x > 0 && pixels->size.y > 0;
  const std::array<std::uint8_t, 4> grey{neutral, neutral, neutral, 255};
  Result<gpu::Texture> texture = gpu::Texture::create2D(label, there ? pixels->size : glm::ivec2(1), GL_RGBA8);
  if (!texture) return texture.error();
  texture->upload(GL_RGBA, GL_UNSIGNED_BYTE, there ? pixels->pixels.data() : grey.data());
  map.texture = std::move(*texture);
  map.pixels = pixels;
  return Done{};
}

Status GrassMaps::configure(const GrassSettings& grass) {
  Status adopted = adopt(m_maps[0], grass.densityPixels, "density map", kAll);
  if (adopted) adopted = adopt(m_maps[1], grass.heightPixels, "height map", kMidGrey);
  if (adopted) adopted = adopt(m_maps[2], grass.colourPixels, "colour map", kMidGrey);
  return adopted;
}

void GrassMaps::bind() const {
  m_maps[0].texture.bind(RENDER_TEXTURE_DENSITY_MAP);
  m_maps[1].texture.bind(RENDER_TEXTURE_HEIGHT_MAP);
  m_maps[2].texture.bind(RENDER_TEXTURE_COLOUR_MAP);
}

}  // namespace windloom
