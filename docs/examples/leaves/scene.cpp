#include "scene.hpp"

#include "leaf_shapes.hpp"
#include "shaders.hpp"

namespace game {

namespace {

const Vec3 kToSun = normalized({-0.62f, 0.52f, 0.30f});
constexpr int kShadowSide = 1024;  // about 12 cm a texel on a field of 100 m

template <class T>
std::size_t bytesOf(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

Program program(const char* name, const ShaderPair& pair) {
  return Program(name, kSharedShader, pair.vertex, pair.fragment);
}

Program shadowProgram(const char* name, const ShaderPair& pair) {
  return Program(name, kSharedShader, pair.vertex, kShadowFragment);
}

/// x, part of the height, z, 1 for the knob; normal.
using PoleCorner = std::array<float, 7>;

PoleCorner poleCorner(float angle, float level, bool knob) {
  const float x = std::cos(angle), z = std::sin(angle);
  if (!knob) return {x * mix(0.10f, 0.065f, level), level, z * mix(0.10f, 0.065f, level), 0, x, 0, z};
  const float up = -std::cos(kPi * level), out = std::sin(kPi * level);  // a ball, level from its foot to its top
  return {0.2f * x * out, 1 + 0.2f * up + 0.12f, 0.2f * z * out, 1, x * out, up, z * out};
}

std::vector<PoleCorner> poleShape() {
  constexpr int kSides = 8, kRings = 5;
  std::vector<PoleCorner> corners;
  const auto ring = [&](float low, float high, bool knob) {
    for (int side = 0; side < kSides; ++side) {
      const float a = 2 * kPi * static_cast<float>(side) / kSides, b = 2 * kPi * static_cast<float>(side + 1) / kSides;
      corners.insert(corners.end(), {poleCorner(a, low, knob), poleCorner(b, low, knob), poleCorner(a, high, knob),
                                     poleCorner(a, high, knob), poleCorner(b, low, knob), poleCorner(b, high, knob)});
    }
  };
  ring(0, 1, false);
  for (int i = 0; i < kRings; ++i) ring(static_cast<float>(i) / kRings, static_cast<float>(i + 1) / kRings, true);
  return corners;
}

/// The other way round: from the screen's corners to directions, for the sky.
Mat4 toDirections(const Mat4& view, float aspect) {
  const float high = std::tan(Camera::kFieldOfView / 2), wide = high * aspect;
  // The rows of the view's turn are the camera's right, up and back.
  return {view[0] * wide,
          view[4] * wide,
          view[8] * wide,
          0,
          view[1] * high,
          view[5] * high,
          view[9] * high,
          0,
          -view[2],
          -view[6],
          -view[10],
          0,
          0,
          0,
          0,
          1};
}

}  // namespace

Scene::Scene(const WindSource& wind, const World& world, std::uint32_t seed)
    : m_bounds(wind.bounds()),
      m_scale(std::min(m_bounds.width(), m_bounds.depth()) / 100),
      m_meadow(m_bounds, seed),
      m_leaf(program("leaves", kLeafShader)),
      m_cloth(program("flags", kClothShader)),
      m_pole(program("poles", kPoleShader)),
      m_streak(program("streaks", kStreakShader)),
      m_leafShadow(shadowProgram("leaves' shadows", kLeafShader)),
      m_clothShadow(shadowProgram("flags' shadows", kClothShader)),
      m_poleShadow(shadowProgram("poles' shadows", kPoleShader)) {
  const float margin = 12 * m_scale;
  m_maskBounds = {m_bounds.minX - margin, m_bounds.minZ - margin, m_bounds.maxX + margin, m_bounds.maxZ + margin};
  makeLeaves(world);
  makeFlags(world);
  makePoles(world);
  makeShadowMask();
  m_streakInput = makeVertexArray();
  m_streakVertices = makeBuffer(GL_ARRAY_BUFFER, nullptr, 0, GL_STREAM_DRAW);
  vertexInput(0, 3, 9, 0);
  vertexInput(1, 3, 9, 3);
  vertexInput(2, 3, 9, 6);
}

/// Leaves are instances of a few shapes. All their places lie in one buffer; each shape begins elsewhere in it.
void Scene::makeLeaves(const World& world) {
  const auto& looks = world.leaves.looks();
  const int each = static_cast<int>(looks.size()) / Leaves::kKinds;
  m_leafLooks = makeBuffer(GL_ARRAY_BUFFER, nullptr, bytesOf(looks), GL_STREAM_DRAW);
  for (int kind = 0; kind < Leaves::kKinds; ++kind) {
    const std::vector<LeafCorner> shape = leafShape(kind);
    m_leafCorners[kind] = static_cast<int>(shape.size());
    m_leafInput[kind] = makeVertexArray();
    m_leafShapes[kind] = makeBuffer(GL_ARRAY_BUFFER, shape.data(), bytesOf(shape), GL_STATIC_DRAW);
    vertexInput(0, 3, 3, 0);
    glBindBuffer(GL_ARRAY_BUFFER, *m_leafLooks);
    for (int i = 0; i < 3; ++i) vertexInput(1 + i, 4, 12, 12 * each * kind + 4 * i, true);
  }
}

void Scene::makeFlags(const World& world) {
  const std::vector<unsigned> indices = world.flags.indices();
  m_clothCount = static_cast<int>(indices.size());
  m_clothInput = makeVertexArray();
  m_clothIndices = makeBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.data(), bytesOf(indices), GL_STATIC_DRAW);
  m_clothVertices = makeBuffer(GL_ARRAY_BUFFER, nullptr, 0, GL_STREAM_DRAW);
  int at = 0, location = 0;
  for (const int floats : {3, 3, 2, 3, 3}) {
    vertexInput(location++, floats, 14, at);
    at += floats;
  }
}

void Scene::makePoles(const World& world) {
  const std::vector<PoleCorner> shape = poleShape();
  m_poleCorners = static_cast<int>(shape.size());
  m_poleInput = makeVertexArray();
  m_poleShape = makeBuffer(GL_ARRAY_BUFFER, shape.data(), bytesOf(shape), GL_STATIC_DRAW);
  vertexInput(0, 4, 7, 0);
  vertexInput(1, 3, 7, 4);
  std::vector<float> places;
  for (const Vec3& pole : world.flags.poles()) {
    places.insert(places.end(), {pole.x, pole.y, pole.z, world.flags.poleHeight()});
  }
  m_polePlaces = makeBuffer(GL_ARRAY_BUFFER, places.data(), bytesOf(places), GL_STATIC_DRAW);
  vertexInput(2, 4, 4, 0, true);
}

/// The ground is flat, so one picture of it, seen along the sun's rays, holds all shadows.
void Scene::makeShadowMask() {
  GLuint texture = 0, target = 0;
  glGenTextures(1, &texture);
  m_shadowMap = Texture(texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kShadowSide, kShadowSide, 0, GL_RED, GL_UNSIGNED_BYTE, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);  // the border is 0: no shadow out there
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  glGenFramebuffers(1, &target);
  m_shadowTarget = Framebuffer(target);
  glBindFramebuffer(GL_FRAMEBUFFER, target);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Scene::draw(const WindSource& wind, const World& world, const Camera& camera, double time, const Quality& quality,
                 int width, int height) {
  const float aspect = static_cast<float>(width) / static_cast<float>(std::max(height, 1));
  const Mat4 view = camera.view();
  const Pass pass{camera.projection(aspect) * view, camera.eye(), static_cast<float>(time)};
  upload(world);
  m_meadow.update(wind);
  m_meadow.bindMaps();
  drawShadows(world, pass);

  m_picture.begin(width, height, quality.samples);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
  drawThings(world, pass, false);
  use(m_meadow.blades, pass);
  m_meadow.drawBlades(quality.blades);
  // What is dear and mostly covered comes last, so that it isn't drawn twice.
  use(m_meadow.ground, pass);
  m_meadow.drawGround();
  drawBackdrop(pass, toDirections(view, aspect));
  drawStreaks(world, pass);
  m_picture.show();
}

void Scene::upload(const World& world) {
  refillBuffer(m_leafLooks, world.leaves.looks().data(), bytesOf(world.leaves.looks()));
  refillBuffer(m_clothVertices, world.flags.vertices().data(), bytesOf(world.flags.vertices()));
  refillBuffer(m_streakVertices, world.streaks.vertices().data(), bytesOf(world.streaks.vertices()));
}

/// Sets what all shaders share.
void Scene::use(const Program& program, const Pass& pass) const {
  program.use();
  program.set("viewProjection", pass.viewProjection);
  program.set("eye", pass.eye);
  program.set("toSun", kToSun);
  program.set("field", m_bounds.minX, m_bounds.minZ, m_bounds.width(), m_bounds.depth());
  program.set("mask", m_maskBounds.minX, m_maskBounds.minZ, m_maskBounds.width(), m_maskBounds.depth());
  program.set("time", pass.time);
  program.set("scale", m_scale);
  program.set("windMap", Meadow::kWindUnit);
  program.set("shadowMap", Meadow::kShadowUnit);
  program.set("meadowMap", Meadow::kMeadowUnit);
  program.set("turfMap", Meadow::kTurfUnit);
}

/// Slides every point along the sun's rays onto the ground, and the ground onto the mask.
Mat4 Scene::ontoGround() const {
  const float sx = 2 / m_maskBounds.width(), sz = 2 / m_maskBounds.depth();
  return {sx, 0,  0, 0, -kToSun.x / kToSun.y * sx,   -kToSun.z / kToSun.y * sz,   0, 0,
          0,  sz, 0, 0, -m_maskBounds.minX * sx - 1, -m_maskBounds.minZ * sz - 1, 0, 1};
}

void Scene::drawShadows(const World& world, const Pass& view) {
  glActiveTexture(GL_TEXTURE0 + Meadow::kShadowUnit);
  glBindTexture(GL_TEXTURE_2D, 0);  // it is drawn into now
  glBindFramebuffer(GL_FRAMEBUFFER, *m_shadowTarget);
  glViewport(0, 0, kShadowSide, kShadowSide);
  glDisable(GL_DEPTH_TEST);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT);
  drawThings(world, {ontoGround(), view.eye, view.time}, true);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glBindTexture(GL_TEXTURE_2D, *m_shadowMap);
  glActiveTexture(GL_TEXTURE0);
}

/// The wood stands in front of the hills, and both in front of the sky, which is drawn where nothing else is.
void Scene::drawBackdrop(const Pass& pass, const Mat4& toDirections) {
  glDepthFunc(GL_LEQUAL);  // later trees are nearer, and hills and sky lie at the far end of the depth buffer
  use(m_meadow.wood, pass);
  m_meadow.drawWood();
  use(m_meadow.sky, pass);
  m_meadow.sky.set("toWorld", toDirections);
  m_meadow.drawSky();
  use(m_meadow.hills, pass);
  m_meadow.drawHills();
  glDepthFunc(GL_LESS);
}

/// Whatever throws a shadow.
void Scene::drawThings(const World& world, const Pass& pass, bool shadows) {
  use(shadows ? m_poleShadow : m_pole, pass);
  glBindVertexArray(*m_poleInput);
  glDrawArraysInstanced(GL_TRIANGLES, 0, m_poleCorners, static_cast<GLsizei>(world.flags.poles().size()));
  use(shadows ? m_clothShadow : m_cloth, pass);
  glBindVertexArray(*m_clothInput);
  glDrawElements(GL_TRIANGLES, m_clothCount, GL_UNSIGNED_INT, nullptr);
  use(shadows ? m_leafShadow : m_leaf, pass);
  const auto each = static_cast<GLsizei>(world.leaves.looks().size()) / Leaves::kKinds;
  for (int kind = 0; kind < Leaves::kKinds; ++kind) {
    glBindVertexArray(*m_leafInput[kind]);
    glDrawArraysInstanced(GL_TRIANGLE_FAN, 0, m_leafCorners[kind], each);
  }
}

void Scene::drawStreaks(const World& world, const Pass& pass) {
  use(m_streak, pass);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  glBindVertexArray(*m_streakInput);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(world.streaks.vertices().size()));
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

}  // namespace game
