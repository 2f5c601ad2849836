// What thinning and levels of detail must not show: shimmer while nothing moves, popping in a slow flight, another
// brightness than that of all blades.
#include <algorithm>
#include <cmath>

#include "engine/io/picture_compare.hpp"
#include "tests/gpu/render/render_fixture.hpp"

namespace windloom {
namespace {

using testing::difference;
using testing::Picture;
using testing::uniformWind;

FloatImage floatsOf(const Picture& picture) {
  FloatImage image(picture.size.x, picture.size.y, 4);
  std::copy(picture.rgba.begin(), picture.rgba.end(), image.pixels.begin());
  return image;
}

double light(const Picture& picture) {
  return meanOf(lightOf(floatsOf(picture)));
}

double middle(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

class MeadowQuality : public testing::RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    setDensity(150.0f);
    setField(16);
    m_wind = uniformWind({0.0f, 0.0f});
    m_input.wind = {m_wind.name(), makeGridMapping(m_project.field->centre, m_project.field->size, {16, 16})};
    m_input.camera.position = {0.0f, 1.7f, 16.0f};
    m_input.camera.target = {0.0f, 1.2f, 0.0f};
  }

  /// Differences of neighbouring pictures of a flight over the still meadow.
  struct Flight {
    std::vector<double> changes, brightness, worstSquares;
  };
  Flight fly(glm::vec3 from, glm::vec3 step, int steps) {
    const glm::vec3 gaze = m_input.camera.target - m_input.camera.position;
    Flight flight;
    Picture before;
    for (int i = 0; i < steps; ++i) {
      m_input.camera.position = from + static_cast<float>(i) * step;
      m_input.camera.target = m_input.camera.position + gaze;
      const Picture now = picture();
      if (i > 0) {
        flight.changes.push_back(static_cast<double>(difference(before, now)));
        flight.brightness.push_back(light(now) / light(before) - 1.0);
        flight.worstSquares.push_back(largestLocalError(lightOf(floatsOf(now)), lightOf(floatsOf(before)), 20));
      }
      before = now;
    }
    return flight;
  }
};

TEST_F(MeadowQuality, SixtyFramesOfAStillMeadowAreTheSameBytes) {
  Picture first;
  for (int frame = 0; frame < 60; ++frame) {
    m_input.time = 3.0 + frame / 60.0;
    const Picture now = picture();
    if (frame == 0) first = now;
    ASSERT_TRUE(now.rgba == first.rgba) << "frame " << frame << " differs by " << difference(now, first);
  }
}

TEST_F(MeadowQuality, NothingPopsInASlowFlight) {
  struct Way {
    const char* name;
    glm::vec3 from, gaze, step;
  };
  for (const Way& way : {Way{"walking", {0, 1.7f, 16}, {0, -0.5f, -16}, {0.004f, 0, -0.02f}},
                         Way{"rising", {0, 4, 30}, {0, -4, -30}, {0, 0.1f, 0}},
                         Way{"high above", {0, 30, 30}, {0, -30, -30}, {0.05f, 0.1f, 0}}}) {
    SCOPED_TRACE(way.name);
    m_input.camera.position = way.from;
    m_input.camera.target = way.from + way.gaze;
    const Flight flight = fly(way.from, way.step, 49);
    const double most = *std::max_element(flight.changes.begin(), flight.changes.end());
    EXPECT_LE(most, 2.5 * middle(flight.changes)) << "mean change of a frame";
    EXPECT_GT(middle(flight.changes), 0.0) << "the camera moves";
    for (const double change : flight.brightness) EXPECT_LT(std::abs(change), 0.01) << "brightness of the picture";
    const double worst = *std::max_element(flight.worstSquares.begin(), flight.worstSquares.end());
    EXPECT_LE(worst, std::max(2.5 * middle(flight.worstSquares), 0.02)) << "brightness of a square";
  }
}

TEST_F(MeadowQuality, ThinningKeepsTheBrightness) {
  m_wind = uniformWind({4.0f, 2.0f});
  m_input.wind.name = m_wind.name();
  m_input.size = {240, 136};
  setDensity(100.0f);
  // The benchmark's views of a meadow of this size, and of a larger one. Here a metre is a few pixels only: what is left of
  // the blades is the ground's shading, which is fitted to pictures a hundred times as large (docs/benchmarks.md).
  for (const glm::vec3 from : {glm::vec3(0, 1.7f, 0.4f * kFieldM), glm::vec3(0, 0.25f, 0.65f) * kFieldM,
                               glm::vec3(0, 1.3f * kFieldM, 0.01f), glm::vec3(0, 1.0f, 2.5f) * kFieldM}) {
    SCOPED_TRACE(::testing::Message() << "from " << from.x << ", " << from.y << ", " << from.z);
    m_input.camera.position = from;
    m_input.camera.target = {0.0f, from.y < 2.0f ? 1.2f : 0.0f, 0.0f};
    m_input.quality = {};
    const double thinned = light(picture());
    m_input.quality = {.thinning = false, .still = true};
    const double every = light(picture());
    EXPECT_NEAR(thinned / every, 1.0, 0.08);
  }
}

TEST_F(MeadowQuality, CullingChangesNoPixel) {
  m_wind = uniformWind({4.0f, 2.0f});
  m_input.wind.name = m_wind.name();
  const Picture culled = picture();
  m_input.quality.culling = false;
  EXPECT_LT(difference(culled, picture()), 0.02f);
}

}  // namespace
}  // namespace windloom
