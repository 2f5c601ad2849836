#pragma once
// All that grass passes find bound in a frame, without drawing one.

#include <functional>
#include <string>
#include <vector>

#include "engine/gpu/texture.hpp"
#include "engine/grass/grass_layout.hpp"
#include "engine/render/frame_block.hpp"
#include "engine/render/ground_pass.hpp"
#include "engine/render/noise_texture.hpp"
#include "shaders/shared/render_bindings.h"
#include "tests/gpu/gpu_test.hpp"

namespace windloom::testing {

/// What must succeed in a test.
template <class T>
T taken(Result<T> made) {
  EXPECT_TRUE(made.ok()) << (made.ok() ? "" : made.error().text());
  return std::move(*made);
}

class GrassPassTest : public GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    m_fieldSettings.size = {16.0f, 16.0f};
    m_fieldSettings.resolution = {8, 8};
    m_grass.flutter = 0.0f;  // the wind as it is, without ripples
    m_noise = taken(createNoiseTexture());
    m_solids = taken(gpu::Texture::create2D("test solids", {1, 1}, GL_RG32F));
    const glm::vec2 farAway(100.0f, 100.0f);
    m_solids.upload(GL_RG, GL_FLOAT, &farAway);
    m_ground = taken(GroundPass::create(shaders()));
    m_frame = taken(gpu::Buffer::create("test frame", sizeof(FrameBlock), gpu::BufferUse::Dynamic));
    m_settings = taken(gpu::Buffer::create("test grass", sizeof(GrassBlock), gpu::BufferUse::Dynamic));
  }
  void TearDown() override {
    for (gpu::Texture* texture : {&m_noise, &m_solids, &m_wind}) *texture = {};
    for (gpu::Buffer* buffer : {&m_frame, &m_settings}) *buffer = {};
    m_ground.reset();
    GpuTest::TearDown();
  }

  /// Wind by cell.
  void blow(const std::function<glm::vec2(int x, int z)>& wind) {
    const glm::ivec2 cells = m_fieldSettings.resolution;
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
      m_heights = nullptr;
    } else {
      auto samples = std::make_shared<HeightSource>();
      samples->samples = {17, 17};
      for (int i = 0; i < 17 * 17; ++i) samples->values.push_back(static_cast<float>(i % 17) / 16.0f);
      samples->highest = 1.0f;
      auto field = std::make_shared<HeightField>();
      field->source = samples;
      field->low = glm::vec2(-32.0f);
      field->size = glm::vec2(64.0f);
      field->factor = 64.0f * rise;
      field->base = -32.0f * rise;
      m_heights = field;
    }
    ASSERT_TRUE(m_ground->configure(m_heights, defaultLight().sunDirection).ok());
  }

  /// As a frame of the renderer binds it at this time.
  void bindFrame(double time) {
    m_project.field = std::make_shared<FieldSettings>(m_fieldSettings);
    m_project.ambient = std::make_shared<AmbientWind>(m_ambient);
    TerrainSettings terrain;
    terrain.heights = m_heights;
    m_project.terrain = std::make_shared<TerrainSettings>(terrain);
    FrameInput input;
    input.project = &m_project;
    input.time = time;
    input.size = {64, 64};
    input.camera.position = {0.0f, 3.0f, 10.0f};
    if (m_wind.name() != 0) {
      input.wind = {m_wind.name(),
                    makeGridMapping(m_fieldSettings.centre, m_fieldSettings.size, m_fieldSettings.resolution)};
    }
    const FrameBlock frame = makeFrameBlock(input, defaultLight());
    m_frame.write(&frame, sizeof frame);
    m_frame.bindUniform(RENDER_UBO_FRAME);
    const GrassBlock block = makeGrassBlock(m_grass, {}, layout(), {}, frame);
    m_settings.write(&block, sizeof block);
    m_settings.bindUniform(RENDER_UBO_GRASS);
    m_noise.bind(RENDER_TEXTURE_NOISE);
    m_solids.bind(RENDER_TEXTURE_SOLIDS);
    m_ground->bind();
    (m_wind.name() != 0 ? m_wind : m_noise).bind(RENDER_TEXTURE_WIND);
  }
  [[nodiscard]] GrassLayout layout() const { return makeGrassLayout(m_fieldSettings, m_grass); }

  /// A program of tests/data/shaders.
  gpu::Program& testProgram(const std::string& file) {
    const std::string path = std::string(WINDLOOM_TEST_DATA) + "/shaders/" + file;
    auto program = shaders().load({path, {path}});
    EXPECT_TRUE(program.ok()) << program.error().text();
    return **program;
  }

  FieldSettings m_fieldSettings;
  GrassSettings m_grass;
  AmbientWind m_ambient;
  std::shared_ptr<const HeightField> m_heights;
  Project m_project;
  gpu::Texture m_noise, m_solids, m_wind;
  std::optional<GroundPass> m_ground;
  gpu::Buffer m_frame, m_settings;
};

}  // namespace windloom::testing
