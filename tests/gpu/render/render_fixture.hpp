#pragma once
// A small picture of a project on a field of 40 m x 40 m: what tests of the renderer begin with.

#include <memory>

#include "tests/gpu/gpu_test.hpp"
#include "tests/gpu/render/picture.hpp"

namespace windloom::testing {

class RenderTest : public GpuTest {
 protected:
  static constexpr float kFieldM = 40.0f;

  void SetUp() override {
    GpuTest::SetUp();
    auto made = FrameRenderer::create(context(), shaders());
    ASSERT_TRUE(made.ok()) << made.error().text();
    m_renderer = std::move(*made);
    m_input.project = &m_project;
    m_input.size = {320, 180};
    m_input.overlays.arrows = false;
  }
  void TearDown() override {
    m_wind = {};
    m_renderer.reset();
    GpuTest::TearDown();
  }

  void setField(int cells) {
    FieldSettings field;
    field.size = {kFieldM, kFieldM};
    field.resolution = {cells, cells};
    m_project.field = std::make_shared<FieldSettings>(field);
  }
  void setDensity(float density) {
    GrassSettings grass;
    grass.density = density;
    m_project.grass = std::make_shared<GrassSettings>(grass);
  }
  template <class Change>
  void setGrass(const Change& change) {
    GrassSettings grass = *m_project.grass;
    change(grass);
    m_project.grass = std::make_shared<GrassSettings>(grass);
  }
  /// The same wind everywhere.
  void blow(glm::vec2 wind) {
    m_wind = uniformWind(wind);
    const FieldSettings& field = *m_project.field;
    m_input.wind = {m_wind.name(), makeGridMapping(field.centre, field.size, {16, 16})};
  }
  Picture picture() { return draw(*m_renderer, m_input); }
  /// What a frame tells.
  FrameStats rendered() {
    auto target = gpu::Framebuffer::create("test picture", m_input.size, {.colour = GL_RGBA8, .depth = 0});
    EXPECT_TRUE(target.ok());
    FrameInput input = m_input;
    input.framebuffer = target->name();
    return m_renderer->render(input);
  }
  /// Looking down, the lower half of the picture is all grass.
  static glm::vec3 meadow(const Picture& shown) { return shown.mean({0, shown.size.y / 2}, shown.size); }

  std::unique_ptr<FrameRenderer> m_renderer;
  Project m_project;
  FrameInput m_input;
  gpu::Texture m_wind;
};

}  // namespace windloom::testing
