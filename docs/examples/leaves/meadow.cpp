#include "meadow.hpp"

#include "horizon.hpp"
#include "meadow_maps.hpp"
#include "shaders.hpp"

namespace game {

namespace {

constexpr int kBlades = 180000;  // what a software renderer can't draw is left out, see drawBlades

Program program(const char* name, const ShaderPair& pair) {
  return Program(name, kSharedShader, pair.vertex, pair.fragment);
}

Texture makeWindMap(int side) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RG32F, side, side, 0, GL_RG, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return Texture(name);
}

}  // namespace

Meadow::Meadow(const Bounds& bounds, std::uint32_t seed)
    : sky(program("the sky", kSkyShader)),
      hills(program("the hills", kHillShader)),
      wood(program("the wood", kWoodShader)),
      ground(program("the ground", kGroundShader)),
      blades(program("the grass", kBladeShader)) {
  Random random(seed + 77);
  m_meadowMap = makeByteTexture(kMeadowSide, 4, meadowTexels(random));
  m_turfMap = makeByteTexture(kTurfSide, 1, turfTexels(random));
  m_windMap = makeWindMap(kMapSide);
  for (int i = 0; i < kMapSide * kMapSide; ++i) {  // texel centres over the whole field
    m_places.push_back(bounds.minX + bounds.width() * (static_cast<float>(i % kMapSide) + 0.5f) / kMapSide);
    m_places.push_back(bounds.minZ + bounds.depth() * (static_cast<float>(i / kMapSide) + 0.5f) / kMapSide);
  }
  m_noInput = makeVertexArray();
  m_groundInput = makeVertexArray();
  const float corners[] = {-1, -1, 1, -1, -1, 1, 1, 1};
  m_corners = makeBuffer(GL_ARRAY_BUFFER, corners, sizeof corners, GL_STATIC_DRAW);
  vertexInput(0, 2, 2, 0);

  const std::vector<HillCorner> hillCorners = game::hills(seed);
  m_hillCorners = static_cast<int>(hillCorners.size());
  m_hillInput = makeVertexArray();
  m_hills = makeBuffer(GL_ARRAY_BUFFER, hillCorners.data(), hillCorners.size() * sizeof(HillCorner), GL_STATIC_DRAW);
  vertexInput(0, 3, 7, 0);
  vertexInput(1, 4, 7, 3);
  const std::vector<WoodCorner> woodCorners = game::wood(bounds, seed);
  m_woodCorners = static_cast<int>(woodCorners.size());
  m_woodInput = makeVertexArray();
  m_wood = makeBuffer(GL_ARRAY_BUFFER, woodCorners.data(), woodCorners.size() * sizeof(WoodCorner), GL_STATIC_DRAW);
  vertexInput(0, 3, 6, 0);
  vertexInput(1, 3, 6, 3);
  growBlades(bounds, seed);
}

/// Blades over the field and a little beyond, in tufts that come in no order.
void Meadow::growBlades(const Bounds& bounds, std::uint32_t seed) {
  Random random(seed + 5);
  const float scale = std::min(bounds.width(), bounds.depth()) / 100;
  std::vector<float> grown;
  grown.reserve(kBlades * 4);
  while (grown.size() < kBlades * 4) {
    // Thinner towards the rim, where the meadow goes over into plain ground.
    const float beyond = 0.35f * random.unit() * random.unit();
    const float x = mix(bounds.minX, bounds.maxX, random.between(-beyond, 1 + beyond));
    const float z = mix(bounds.minZ, bounds.maxZ, random.between(-beyond, 1 + beyond));
    const int tuft = static_cast<int>(random.between(3, 9));
    const float tall = random.between(0.3f, 0.7f) * scale;
    for (int i = 0; i < tuft && grown.size() < kBlades * 4; ++i) {
      const float away = 0.35f * scale * random.unit(), angle = random.between(-kPi, kPi);
      grown.insert(grown.end(), {x + away * std::cos(angle), z + away * std::sin(angle),
                                 tall * random.between(0.7f, 1.2f), random.unit()});
    }
  }
  m_bladeInput = makeVertexArray();
  m_blades = makeBuffer(GL_ARRAY_BUFFER, grown.data(), grown.size() * sizeof(float), GL_STATIC_DRAW);
  vertexInput(0, 4, 4, 0, true);
}

void Meadow::update(const WindSource& wind) {
  wind.sampleMany(m_places, m_winds);
  glBindTexture(GL_TEXTURE_2D, *m_windMap);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kMapSide, kMapSide, GL_RG, GL_FLOAT, m_winds.data());
}

void Meadow::bindMaps() const {
  const std::pair<int, GLuint> maps[] = {{kWindUnit, *m_windMap}, {kMeadowUnit, *m_meadowMap}, {kTurfUnit, *m_turfMap}};
  for (const auto& [unit, texture] : maps) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture);
  }
  glActiveTexture(GL_TEXTURE0);
}

void Meadow::drawSky() const {
  glBindVertexArray(*m_noInput);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Meadow::drawHills() const {
  glBindVertexArray(*m_hillInput);
  glDrawArrays(GL_TRIANGLES, 0, m_hillCorners);
}

void Meadow::drawWood() const {
  glBindVertexArray(*m_woodInput);
  glDrawArrays(GL_TRIANGLES, 0, m_woodCorners);
}

void Meadow::drawGround() const {
  glBindVertexArray(*m_groundInput);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void Meadow::drawBlades(float share) const {
  glBindVertexArray(*m_bladeInput);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 5, static_cast<GLsizei>(share * kBlades));
}

}  // namespace game
