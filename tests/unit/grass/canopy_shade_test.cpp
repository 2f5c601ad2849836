#include <gtest/gtest.h>

#include <algorithm>

#include "engine/model/project.hpp"
#include "shaders/shared/canopy_shade.h"

namespace windloom {
namespace {

using shared::boundedForce;
using shared::canopyShade;
using shared::vec4;

/// Eq. 14 as printed: c_f / c_t = max(m_min, min(P''_y - |F| c1 + c2, m_max)).
double printed(double height, double force, const vec4& s) {
  return std::max(double(s.x), std::min(height - force * double(s.z) + double(s.w), double(s.y)));
}

TEST(CanopyShade, IsThePapersEquation) {
  const GrassSettings grass;
  for (const vec4 s : {vec4(grass.shadowMin, grass.shadowMax, grass.shadowWind, grass.shadowOffset),
                       vec4(0.1f, 1.4f, 0.9f, -0.2f), vec4(0.0f, 1.0f, 0.0f, 0.0f)}) {
    for (float height = 0.0f; height <= 1.0f; height += 0.05f) {
      for (float force = 0.0f; force <= 3.0f; force += 0.25f) {
        EXPECT_NEAR(double(canopyShade(height, force, s)), printed(double(height), double(force), s), 1e-6);
      }
    }
  }
}

TEST(CanopyShade, LowAndPushedDownGrassIsDarker) {
  const vec4 shadow(0.2f, 1.0f, 0.3f, 0.3f);
  EXPECT_LT(canopyShade(0.2f, 0.5f, shadow), canopyShade(0.6f, 0.5f, shadow));
  EXPECT_LT(canopyShade(0.6f, 1.0f, shadow), canopyShade(0.6f, 0.2f, shadow));
}

TEST(CanopyShade, AGaleNeverDarkensMoreThanTheBoundedForce) {
  const GrassSettings grass;
  const vec4 shadow(grass.shadowMin, grass.shadowMax, grass.shadowWind, grass.shadowOffset);
  float before = -1.0f;
  for (float speed = 0.0f; speed <= 40.0f; speed += 0.5f) {
    const float force = boundedForce(grass.windFactor * speed);
    EXPECT_GT(force, before);
    EXPECT_LT(force, 1.0f);
    before = force;
    // The arc's tip stays over 15% of the height: so much light is left there.
    EXPECT_GT(canopyShade(0.15f, force, shadow), 0.34f);
  }
}

}  // namespace
}  // namespace windloom
