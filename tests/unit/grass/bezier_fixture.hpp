#pragma once
// Projects with Bezier grass for tests, and what their blades say.

#include <functional>
#include <vector>

#include "engine/grass/bezier_placement.hpp"
#include "engine/grass/blade_traits.hpp"
#include "engine/grass/patch_order.hpp"
#include "shaders/shared/bezier_pose.h"
#include "tests/height_fixture.hpp"

namespace windloom::testing {

/// A field around the origin; a change to the settings makes another one.
struct BezierScene {
  glm::vec2 size{40.0f, 40.0f};
  GrassSettings grass;
  BezierSettings bezier;
  std::vector<Surface> surfaces;
  std::shared_ptr<const HeightField> heights;

  BezierScene() { grass.density = 50.0f; }

  [[nodiscard]] Project project() const {
    Project project;
    FieldSettings field;
    field.size = size;
    project.field = std::make_shared<FieldSettings>(field);
    project.grass = std::make_shared<GrassSettings>(grass);
    project.bezier = std::make_shared<BezierSettings>(bezier);
    project.surfaces = std::make_shared<std::vector<Surface>>(surfaces);
    if (heights) project.terrain = terrainOf(heights);
    return project;
  }
  [[nodiscard]] BezierMeadow place() const { return placeBezier(project()); }
};

/// Nothing on the ground, one surface.
inline BezierScene sceneOf(SurfaceShape shape, float size, float density) {
  BezierScene scene;
  scene.grass.density = 0.0f;
  Surface surface;
  surface.id = 5;
  surface.shape = shape;
  surface.size = size;
  surface.density = density;
  scene.surfaces.push_back(surface);
  return scene;
}

inline BezierScene sceneOf(PlantMesh mesh, float density) {
  BezierScene scene = sceneOf(SurfaceShape::Mesh, 1.0f, density);
  scene.surfaces[0].mesh = std::make_shared<PlantMesh>(std::move(mesh));
  return scene;
}

inline glm::vec3 rootOf(const BezierBlade& blade) {
  return {blade.x, blade.y, blade.z};
}
inline glm::vec3 frontOf(const BezierBlade& blade) {
  const glm::vec3 up = upOf(blade);
  return shared::bezierFront(up, shared::bezierAcross(up, static_cast<float>(blade.growth >> 16) / 65535.0f));
}
inline float heightOf(const BezierBlade& blade) {
  return sizesOf(blade).x;
}

/// Those that grow, without what fills patches up.
inline std::vector<BezierBlade> grown(const BezierMeadow& meadow) {
  std::vector<BezierBlade> blades;
  for (const BezierBlade& blade : meadow.blades) {
    if (heightOf(blade) > 0.0f) blades.push_back(blade);
  }
  return blades;
}

inline std::vector<BezierBlade> inField(const BezierScene& scene, const BezierMeadow& meadow) {
  std::vector<BezierBlade> blades;
  for (const BezierBlade& blade : grown(meadow)) {
    const glm::vec2 away = glm::abs(glm::vec2(blade.x, blade.z));
    if (away.x <= 0.5f * scene.size.x && away.y <= 0.5f * scene.size.y) blades.push_back(blade);
  }
  return blades;
}

/// Chi-square over its degrees of freedom, in standard deviations above what chance gives.
inline double chiSquareExcess(const std::vector<double>& found, const std::vector<double>& expected) {
  double sum = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
    sum += (found[i] - expected[i]) * (found[i] - expected[i]) / expected[i];
  const double freedom = static_cast<double>(found.size()) - 1;
  return (sum - freedom) / std::sqrt(2.0 * freedom);
}

/// Distance of a place to the nearest point of a triangle mesh's triangle (Ericson, "Real-time collision detection",
/// 2005).
inline float toTriangle(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const auto toEdge = [&](glm::vec3 from, glm::vec3 to) {
    const glm::vec3 way = to - from;
    const float t = std::clamp(glm::dot(p - from, way) / std::max(glm::dot(way, way), 1e-20f), 0.0f, 1.0f);
    return glm::distance(p, from + way * t);
  };
  const auto within = [&](glm::vec3 from, glm::vec3 to) {
    return glm::dot(glm::cross(normal, to - from), p - from) >= 0.0f;
  };
  if (within(a, b) && within(b, c) && within(c, a)) return std::abs(glm::dot(p - a, glm::normalize(normal)));
  return std::min({toEdge(a, b), toEdge(b, c), toEdge(c, a)});
}

}  // namespace windloom::testing
