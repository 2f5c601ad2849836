// Uneven ground in pictures: it lies where the camera's projection says, and grass stands on it.
#include <cmath>

#include "engine/grass/grass_layout.hpp"
#include "shaders/shared/grass_block.h"
#include "shaders/shared/render_bindings.h"
#include "tests/gpu/render/render_fixture.hpp"
#include "tests/height_fixture.hpp"

namespace windloom {
namespace {

using testing::difference;
using testing::draw;
using testing::heightsFrom;
using testing::Picture;
using testing::terrainOf;
using testing::uniformWind;

/// The first `count` elements of the buffer bound there.
template <class T>
std::vector<T> bound(unsigned binding, std::size_t count) {
  std::vector<T> values(count);
  GLint name = 0;
  glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, binding, &name);
  EXPECT_NE(name, 0);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  if (name != 0 && count > 0)
    glGetNamedBufferSubData(static_cast<GLuint>(name), 0, static_cast<GLsizeiptr>(count * sizeof(T)), values.data());
  return values;
}

class Ground : public testing::RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    setDensity(0.0f);
    setField(16);
    m_input.camera.position = {0.0f, 6.0f, 30.0f};
    m_input.camera.target = {0.0f, 4.0f, 0.0f};
  }

  glm::vec2 pixelOf(glm::vec3 world) const {
    const glm::vec4 clip = m_input.camera.projection(320.0f / 180.0f) * m_input.camera.view() * glm::vec4(world, 1.0f);
    const glm::vec2 device = glm::vec2(clip) / clip.w;
    return {(0.5f + 0.5f * device.x) * 320.0f, (0.5f - 0.5f * device.y) * 180.0f};
  }
};

/// The row of a column at which the picture changes from sky to what stands before it, from above.
int skyline(const Picture& with, const Picture& empty, int x) {
  for (int y = 0; y < with.size.y; ++y) {
    if (glm::length(with.at(x, y) - empty.at(x, y)) > 25.0f) return y;
  }
  return with.size.y;
}

}  // namespace

TEST_F(Ground, RidgesReachAsHighAsTheProjectionSays) {
  const Picture empty = picture();
  const auto ridge = [](glm::vec2 p) {
    return 9.0f * std::exp(-p.y * p.y / 18.0f) * (0.75f + 0.25f * std::sin(0.3f * p.x));
  };
  m_project.terrain = terrainOf(heightsFrom({257, 257}, {60, 60}, ridge));
  const Picture hills = picture();
  for (const float x : {-9.0f, -4.0f, 0.0f, 3.0f, 8.0f}) {
    const glm::vec2 top = pixelOf({x, heightAt(*m_project.terrain->heights, {x, 0}), 0.0f});
    EXPECT_NEAR(static_cast<float>(skyline(hills, empty, static_cast<int>(top.x))), top.y, 2.0f) << "x = " << x;
  }
}

TEST_F(Ground, EdgesGoOnToTheHorizon) {
  const Picture flat = picture();
  m_project.terrain = terrainOf(heightsFrom({33, 33}, {8, 8}, [](glm::vec2) { return 0.0f; }));
  const Picture level = picture();
  EXPECT_LT(difference(level, flat), 1.0f) << "a small level patch at 0 looks like flat ground everywhere";
  m_project.terrain = terrainOf(heightsFrom({33, 33}, {8, 8}, [](glm::vec2) { return 2.0f; }));
  m_input.camera.position.y += 2.0f;
  m_input.camera.target.y += 2.0f;
  EXPECT_LT(difference(picture(), flat), 4.0f) << "and one raised with the camera as well";
}

TEST_F(Ground, GrassStandsOnIt) {
  const auto slope = heightsFrom(
      {65, 65}, {60, 60}, [](glm::vec2 p) { return 3.0f + 2.5f * std::sin(0.2f * p.x) * std::cos(0.17f * p.y); });
  m_project.terrain = terrainOf(slope);
  setDensity(40.0f);
  (void)picture();
  // The placing pass left its buffers bound: read what it made.
  const shared::GrassCommands commands = bound<shared::GrassCommands>(RENDER_SSBO_COMMANDS, 1).front();
  const std::vector<shared::GrassChunk> chunks = bound<shared::GrassChunk>(RENDER_SSBO_CHUNKS, commands.chunks);
  const std::vector<shared::GrassBlade> places =
      bound<shared::GrassBlade>(RENDER_SSBO_BLADES, commands.chunks * GRASS_CHUNK);
  // A chunk's blades stand at the front of its places.
  std::vector<shared::GrassBlade> blades;
  for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
    const auto first = places.begin() + static_cast<std::ptrdiff_t>(chunk * GRASS_CHUNK);
    blades.insert(blades.end(), first, first + static_cast<std::ptrdiff_t>(chunks[chunk].count));
  }
  EXPECT_EQ(blades.size(), commands.blades);
  ASSERT_GT(blades.size(), 1000u);
  float lowest = 100, highest = -100;
  for (const shared::GrassBlade& blade : blades) {
    const float part = static_cast<float>(blade.facing >> 16) / 65535.0f;
    const float height = glm::mix(slope->lowest(), slope->highest(), part);
    EXPECT_NEAR(height, heightAt(*slope, {blade.x, blade.z}), 1e-3f);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  EXPECT_GT(highest - lowest, 1.0f) << "blades stand high and low";
}

TEST_F(Ground, SlopesAwayFromTheSunAreDarker) {
  m_input.camera = testing::above({0, 0}, 20.0f);
  const auto lean = [&](float sign) {
    m_project.terrain = terrainOf(
        heightsFrom({33, 33}, {200, 200}, [&](glm::vec2 p) { return 30.0f + sign * 0.3f * (p.x + p.y) / 1.414f; }));
    return glm::dot(picture().mean({0, 0}, {320, 180}), glm::vec3(1.0f / 3.0f));
  };
  // The sun stands over -x, -z: ground that rises towards +x, +z faces it.
  EXPECT_GT(lean(1.0f), 1.15f * lean(-1.0f));
}

}  // namespace windloom
