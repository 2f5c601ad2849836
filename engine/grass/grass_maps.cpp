#include "engine/grass/grass_maps.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

#include "shaders/shared/plant_block.h"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

constexpr std::uint8_t kAll = 255, kMidGrey = 128;  // what changes nothing
constexpr float kSoftDeg = 4.0f;                    // of the edge around the slope limit, either way

shared::GrassMapBlock makeBlock(const GrassSettings& grass) {
  const auto cosine = [](float degrees) { return std::cos(glm::radians(std::clamp(degrees, 0.0f, 180.0f))); };
  shared::GrassMapBlock block{};
  block.slope = {cosine(grass.slopeLimit + kSoftDeg), cosine(grass.slopeLimit - kSoftDeg), 0.0f, 0.0f};
  return block;
}

}  // namespace

Result<GrassMaps> GrassMaps::create() {
  GrassMaps maps;
  Result<gpu::Buffer> block = gpu::Buffer::create("grass maps", sizeof(shared::GrassMapBlock), gpu::BufferUse::Dynamic);
  if (!block) return block.error();
  maps.m_block = std::move(*block);
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
  if (!adopted) return adopted;
  const shared::GrassMapBlock block = makeBlock(grass);
  m_block.write(&block, sizeof block);
  return Done{};
}

void GrassMaps::bind() const {
  m_maps[0].texture.bind(RENDER_TEXTURE_DENSITY_MAP);
  m_maps[1].texture.bind(RENDER_TEXTURE_HEIGHT_MAP);
  m_maps[2].texture.bind(RENDER_TEXTURE_COLOUR_MAP);
  m_block.bindUniform(RENDER_UBO_GRASS_MAPS);
}

}  // namespace windloom
