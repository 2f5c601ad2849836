#pragma once
// All that grass passes find bound in a frame, without drawing one.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/contract.hpp"
#include "engine/core/log.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/grass/grass_layout.hpp"
#include "engine/grass/grass_maps.hpp"
#include "engine/grass/rotors.hpp"
#include "engine/render/frame_block.hpp"
#include "engine/render/ground_pass.hpp"
#include "engine/render/noise_texture.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom::testing {

/// What must succeed.
template <class T>
T taken(Result<T> made) {
  if (!made.ok()) logError(made.error().text());
  WL_REQUIRE(made.ok(), "what a test needs can be made");
  return std::move(*made);
}

class GrassScene {
 public:
  explicit GrassScene(gpu::ShaderLibrary& shaders) {
    field.size = {16.0f, 16.0f};
    field.resolution = {8, 8};
    grass.flutter = 0.0f;  // the wind as it is, without ripples
    m_noise = taken(createNoiseTexture());
    m_solids = taken(gpu::Texture::create2D("test solids", {1, 1}, GL_RG32F));
    const glm::vec2 farAway(100.0f, 100.0f);
    m_solids.upload(GL_RG, GL_FLOAT, &farAway);
    m_ground = taken(GroundPass::create(shaders));
    m_maps = taken(GrassMaps::create());
    WL_REQUIRE(m_maps->configure(grass).ok(), "no maps fit");
    m_rotors = taken(Rotors::create());
    m_frame = taken(gpu::Buffer::create("test frame", sizeof(FrameBlock), gpu::BufferUse::Dynamic));
    m_settings = taken(gpu::Buffer::create("test grass", sizeof(GrassBlock), gpu::BufferUse::Dynamic));
  }

  /// Wind by cell.
  void blow(const std::function<glm::vec2(int x, int z)>& wind) {
    const glm::ivec2 cells = field.resolution;
    std::vector<glm::vec2> values;
    for (int z = 0; z < cells.y; ++z) {
      for (int x = 0; x < cells.x; ++x) values.push_back(wind(x, z));
    }
    if (glm::ivec2(m_wind.size()) != cells) m_wind = taken(gpu::Texture::create2D("test wind", cells, GL_RG32F));
    m_wind.upload(GL_RG, GL_FLOAT, values.data());
  }
  void blow(glm::vec2 wind) {
    blow([&](int, int) { return wind; });
  }

  /// A slope along x, m for each m; 0: flat.
  void setSlope(float rise) {
    if (rise == 0.0f) {
      heights = nullptr;
    } else {
      auto samples = std::make_shared<HeightSource>();
      samples->samples = {17, 17};
      for (int i = 0; i < 17 * 17; ++i) samples->values.push_back(static_cast<float>(i % 17) / 16.0f);
      samples->highest = 1.0f;
      auto slope = std::make_shared<HeightField>();
      slope->source = samples;
      slope->low = glm::vec2(-32.0f);
      slope->size = glm::vec2(64.0f);
      slope->factor = 64.0f * rise;
      slope->base = -32.0f * rise;
      heights = slope;
    }
    WL_REQUIRE(m_ground->configure(heights, defaultLight().sunDirection).ok(), "the ground fits");
  }

  /// As a frame of the renderer binds it at this time.
  void bindFrame(double time) {
    m_project.field = std::make_shared<FieldSettings>(field);
    m_project.ambient = std::make_shared<AmbientWind>(ambient);
    TerrainSettings terrain;
    terrain.heights = heights;
    m_project.terrain = std::make_shared<TerrainSettings>(terrain);
    FrameInput input;
    input.project = &m_project;
    input.time = time;
    input.size = size;
    input.camera = camera;
    if (m_wind.name() != 0) {
      input.wind = {m_wind.name(), makeGridMapping(field.centre, field.size, field.resolution)};
    }
    frame = makeFrameBlock(input, defaultLight());
    m_frame.write(&frame, sizeof frame);
    m_frame.bindUniform(RENDER_UBO_FRAME);
    const GrassBlock block = makeGrassBlock(grass, {}, layout(), {}, frame);
    m_settings.write(&block, sizeof block);
    m_settings.bindUniform(RENDER_UBO_GRASS);
    m_noise.bind(RENDER_TEXTURE_NOISE);
    m_solids.bind(RENDER_TEXTURE_SOLIDS);
    m_ground->bind();
    m_maps->bind();
    m_rotors->bind(rotors, time);
    (m_wind.name() != 0 ? m_wind : m_noise).bind(RENDER_TEXTURE_WIND);
  }
  [[nodiscard]] GrassLayout layout() const { return makeGrassLayout(field, grass); }

  FieldSettings field;
  GrassSettings grass;
  AmbientWind ambient;
  std::shared_ptr<const HeightField> heights;
  std::vector<Rotor> rotors;
  ViewCamera camera = [] {
    ViewCamera at;
    at.position = {0.0f, 3.0f, 10.0f};
    return at;
  }();
  glm::ivec2 size{64, 64};
  FrameBlock frame{};  ///< of the last bindFrame()

 private:
  Project m_project;
  gpu::Texture m_noise, m_solids, m_wind;
  std::optional<GroundPass> m_ground;
  std::optional<GrassMaps> m_maps;
  std::optional<Rotors> m_rotors;
  gpu::Buffer m_frame, m_settings;
};

}  // namespace windloom::testing
