#include "engine/grass/flower_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/contract.hpp"

namespace windloom {
namespace {

constexpr float kTurn = 2.0f * std::numbers::pi_v<float>;
// Neighbouring leaves and petals of plants stand this part of a turn apart.
constexpr float kGoldenTurn = 0.381966f;

/// How a vertex moves and is coloured.
struct Skin {
  glm::vec3 colour{1.0f};
  float petal = 0.0f;  ///< 0..1
  float free = 0.0f;   ///< 0..1
};

class Builder {
 public:
  std::uint32_t vertex(glm::vec3 place, glm::vec3 normal, const Skin& skin) {
    const float size = glm::length(normal);
    m_mesh.vertices.push_back({place,
                               size > 1e-6f ? normal / size : glm::vec3(0, 1, 0),
                               {skin.petal, skin.free},
                               glm::vec4(skin.colour, 1.0f)});
    return static_cast<std::uint32_t>(m_mesh.vertices.size() - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    m_mesh.indices.insert(m_mesh.indices.end(), {a, b, c});
  }
  void quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    triangle(a, b, c);
    triangle(a, c, d);
  }
  PlantMesh finish() {
    m_mesh.low = m_mesh.high = glm::vec3(0.0f);
    for (const PlantVertex& v : m_mesh.vertices) {
      m_mesh.low = glm::min(m_mesh.low, v.position);
      m_mesh.high = glm::max(m_mesh.high, v.position);
    }
    return std::move(m_mesh);
  }

 private:
  PlantMesh m_mesh;
};

glm::vec3 around(float turn, float y = 0.0f) {
  return {std::cos(kTurn * turn), y, std::sin(kTurn * turn)};
}

/// The measures and colours of one species, in units of its height.
struct Plant {
  float stem;  ///< radius at the base
  glm::vec3 foot, green, petal;

  explicit Plant(const Species& species)
      : stem(0.5f * std::clamp(species.width / std::max(species.height, 0.01f), 0.002f, 0.02f)),
        foot(species.baseColour),
        green(species.baseColour * 3.6f + glm::vec3(0.01f, 0.02f, 0.0f)),
        petal(species.tipColour) {}

  /// The middle of the stem: not quite straight.
  static glm::vec3 spine(float s) {
    return {0.018f * std::sin(5.0f * s), s, 0.014f * std::sin(3.4f * s + 0.6f) - 0.0079f};
  }
  [[nodiscard]] Skin leaf(float y, float free = 0.0f) const {
    return {glm::mix(foot, green, glm::smoothstep(0.0f, 0.7f, y)), 0.0f, free};
  }
};

/// A stem of three sides up to `top`.
void addStem(Builder& b, const Plant& plant, float top, int rows, int sides = 3) {
  std::vector<std::uint32_t> ring;
  for (int row = 0; row <= rows; ++row) {
    const float s = top * static_cast<float>(row) / static_cast<float>(rows);
    const float radius = plant.stem * (1.0f - 0.45f * s);
    std::vector<std::uint32_t> next;
    for (int side = 0; side < sides; ++side) {
      const glm::vec3 out = around(static_cast<float>(side) / static_cast<float>(sides));
      next.push_back(b.vertex(Plant::spine(s) + out * radius, out, plant.leaf(s)));
    }
    for (std::size_t i = 0; row > 0 && i < next.size(); ++i) {
      const std::size_t n = (i + 1) % next.size();
      b.quad(ring[i], ring[n], next[n], next[i]);
    }
    ring = next;
  }
}

/// A stem as two flat strips that cross, for the distance: a little wider, as thin lines vanish.
void addFlatStem(Builder& b, const Plant& plant, float top) {
  for (const float turn : {0.07f, 0.32f}) {
    const glm::vec3 side = around(turn) * plant.stem * 1.3f;
    const glm::vec3 out = around(turn + 0.25f);
    const glm::vec3 tip = Plant::spine(top);
    b.quad(b.vertex(-side, out, plant.leaf(0)), b.vertex(side, out, plant.leaf(0)),
           b.vertex(tip + side * 0.7f, out, plant.leaf(top)), b.vertex(tip - side * 0.7f, out, plant.leaf(top)));
  }
}

/// A leaf of 2 quads and a tip that rises and hangs over.
void addLeaf(Builder& b, const Plant& plant, float y, float turn, float length, float width, float rise) {
  const glm::vec3 out = around(turn), side = around(turn + 0.25f);
  const glm::vec3 root = Plant::spine(y);
  std::uint32_t left = 0, right = 0;
  for (int row = 0; row < 3; ++row) {
    const float t = static_cast<float>(row) / 3.0f;
    const float wide = width * (row == 0 ? 0.35f : row == 1 ? 1.0f : 0.75f);
    const glm::vec3 at = root + out * (length * t) + glm::vec3(0, length * (rise * t - 0.55f * t * t), 0);
    const glm::vec3 normal = glm::normalize(glm::vec3(0, 1, 0) - out * (rise - 1.1f * t));
    const Skin skin{glm::mix(plant.leaf(0.25f + 0.5f * y).colour, plant.green, t), 0.0f, 0.5f * t};
    const std::uint32_t l = b.vertex(at - side * wide, normal - 0.35f * side, skin);
    const std::uint32_t r = b.vertex(at + side * wide, normal + 0.35f * side, skin);
    if (row > 0) b.quad(left, right, r, l);
    left = l;
    right = r;
  }
  const glm::vec3 tip = root + out * length + glm::vec3(0, length * (rise - 0.55f), 0);
  b.triangle(left, right, b.vertex(tip, glm::vec3(0, 1, 0) + 0.4f * out, {plant.green, 0.0f, 0.6f}));
}

/// Right-handed axes of a head whose face looks along `face`.
struct Head {
  glm::vec3 centre, face, u, v;
  Head(glm::vec3 at, glm::vec3 towards) : centre(at), face(glm::normalize(towards)) {
    u = glm::normalize(glm::cross(face, glm::vec3(0, 0.1f, 1)));
    v = glm::cross(u, face);
  }
  [[nodiscard]] glm::vec3 out(float turn) const { return u * std::cos(kTurn * turn) + v * std::sin(kTurn * turn); }
  [[nodiscard]] glm::vec3 at(float turn, float radius, float rise) const {
    return centre + out(turn) * radius + face * rise;
  }
};

/// A dome: its rim at `radius`, its middle `rise` higher.
void addDome(Builder& b, const Head& head, float radius, float foot, float rise, int sides, const Skin& rim,
             const Skin& middle) {
  const std::uint32_t top = b.vertex(head.centre + head.face * (foot + rise), head.face, middle);
  const auto first = static_cast<std::uint32_t>(top + 1);
  for (int i = 0; i < sides; ++i) {
    const float turn = static_cast<float>(i) / static_cast<float>(sides);
    b.vertex(head.at(turn, radius, foot), head.out(turn) * std::abs(rise) + head.face * radius, rim);
  }
  for (int i = 0; i < sides; ++i) {
    const auto a = static_cast<std::uint32_t>(i), c = static_cast<std::uint32_t>((i + 1) % sides);
    b.triangle(top, first + a, first + c);
  }
}

// Daisy.

constexpr glm::vec3 kDiscRim{0.62f, 0.36f, 0.02f}, kDiscMiddle{0.80f, 0.56f, 0.035f};
constexpr float kDaisyRadius = 0.062f;
const glm::vec3 kDaisyFace{0.42f, 1.0f, 0.16f};

void addRay(Builder& b, const Plant& plant, const Head& head, int index, int count) {
  const float turn =
      (static_cast<float>(index) + 0.22f * std::sin(7.3f * static_cast<float>(index))) / static_cast<float>(count);
  const float length = kDaisyRadius * (0.93f + 0.09f * std::sin(4.1f * static_cast<float>(index)));
  const float droop = -0.10f - 0.07f * std::sin(2.7f * static_cast<float>(index));
  const float half = 0.55f / static_cast<float>(count);  // of a turn, at the middle: rays overlap a little
  const glm::vec3 normal = head.face + 0.25f * head.out(turn);
  const Skin inner{plant.petal * glm::vec3(0.80f, 0.80f, 0.70f), 1.0f, 0.1f}, mid{plant.petal, 1.0f, 0.5f},
      tip{plant.petal * 1.03f, 1.0f, 0.9f};
  const float r0 = 0.3f * length, r1 = 0.72f * length;
  const glm::vec3 side = head.out(turn + 0.25f) * (r1 * kTurn * half);
  const std::uint32_t a = b.vertex(head.at(turn, r0, 0.004f) - side * 0.45f, normal, inner);
  const std::uint32_t c = b.vertex(head.at(turn, r0, 0.004f) + side * 0.45f, normal, inner);
  const std::uint32_t d = b.vertex(head.at(turn, r1, 0.006f + 0.4f * droop * length) - side, normal - 0.2f * side, mid);
  const std::uint32_t e = b.vertex(head.at(turn, r1, 0.006f + 0.4f * droop * length) + side, normal + 0.2f * side, mid);
  b.quad(a, c, e, d);
  b.triangle(d, e, b.vertex(head.at(turn, length, droop * length), normal + 0.3f * head.out(turn), tip));
}

FlowerMesh makeDaisy(const Plant& plant) {
  FlowerMesh made;
  const Head head(Plant::spine(0.985f), kDaisyFace);
  Builder near;
  addStem(near, plant, 0.985f, 4);
  for (int i = 0; i < 5; ++i) {
    const auto n = static_cast<float>(i);
    addLeaf(near, plant, i < 3 ? 0.0f : 0.12f * n - 0.1f, kGoldenTurn * n + 0.1f, 0.26f - 0.03f * n, 0.018f, 1.05f);
  }
  constexpr int kRays = 17;
  addDome(near, head, 0.45f * kDaisyRadius, -0.002f, -0.022f, 6, plant.leaf(1), plant.leaf(1));
  for (int i = 0; i < kRays; ++i) addRay(near, plant, head, i, kRays);
  addDome(near, head, 0.36f * kDaisyRadius, 0.004f, 0.011f, 8, {kDiscRim, 0.6f, 0}, {kDiscMiddle, 0.6f, 0});
  made.near = near.finish();

  Builder far;
  addFlatStem(far, plant, 0.985f);
  addDome(far, head, 0.88f * kDaisyRadius, -0.004f, 0.008f, 7, {plant.petal * 0.97f, 1, 0.5f},
          {plant.petal * 0.9f, 1, 0});
  addDome(far, head, 0.36f * kDaisyRadius, 0.006f, 0.008f, 4, {kDiscRim, 0.6f, 0}, {kDiscMiddle, 0.6f, 0});
  made.far = far.finish();
  return made;
}

// Poppy.

constexpr float kPoppyRadius = 0.085f;
const glm::vec3 kPoppyFace{0.34f, 1.0f, -0.22f};
constexpr glm::vec3 kBlotch{0.012f, 0.008f, 0.012f};

/// One of four petals: a curved sheet of 4 x 3 quads with a ruffled edge.
void addCupPetal(Builder& b, const Plant& plant, const Head& head, int index) {
  constexpr int kColumns = 4, kRows = 3;
  const float middle = 0.25f * static_cast<float>(index) + 0.03f;
  const bool outer = index % 2 == 0;
  std::uint32_t grid[kRows + 1][kColumns + 1];
  for (int row = 0; row <= kRows; ++row) {
    const float t = static_cast<float>(row) / kRows;
    for (int column = 0; column <= kColumns; ++column) {
      const float c = 2.0f * static_cast<float>(column) / kColumns - 1.0f;
      const float turn = middle + c * (0.06f + 0.115f * t);
      const float own = static_cast<float>(index);
      const float ruffle = t * t * t * (0.09f * std::sin(31.0f * turn + 2.0f * own) + 0.05f * std::sin(67.0f * turn));
      const float wide = kPoppyRadius * (0.10f + (outer ? 0.90f : 0.78f) * std::pow(t, 0.75f));
      const float radius = wide * (1.0f - (0.02f + 0.12f * t) * c * c);
      const float rise = kPoppyRadius * ((outer ? 0.66f : 0.82f) * t * t + ruffle);
      const glm::vec3 normal = head.face * (1.1f - 0.8f * t) - head.out(turn + 0.3f * ruffle) * (0.2f + 0.7f * t);
      // A dark blotch inside, deeper red low, silky light at the rim and along the folds.
      const float fold = 1.0f + 0.12f * std::sin(43.0f * turn + own) * t;
      const glm::vec3 colour = row == 0 ? kBlotch : plant.petal * (0.16f + 1.0f * std::pow(t, 0.9f)) * fold;
      grid[row][column] = b.vertex(head.at(turn, radius, rise), normal, {colour, row == 0 ? 0.2f : 1.0f, t});
    }
  }
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column)
      b.quad(grid[row][column], grid[row][column + 1], grid[row + 1][column + 1], grid[row + 1][column]);
  }
}

FlowerMesh makePoppy(const Plant& plant) {
  FlowerMesh made;
  const Head head(Plant::spine(0.93f), kPoppyFace);
  Builder near;
  addStem(near, plant, 0.93f, 4);
  for (int i = 0; i < 6; ++i) {
    const auto n = static_cast<float>(i);
    addLeaf(near, plant, 0.03f + 0.055f * n, kGoldenTurn * n, 0.27f - 0.025f * n, 0.022f, 0.95f);
  }
  for (int i = 0; i < 4; ++i) addCupPetal(near, plant, head, i);
  addDome(near, head, 0.26f * kPoppyRadius, 0.006f, 0.02f, 6, {kBlotch, 0.2f, 0.1f}, {kBlotch * 2.0f, 0.2f, 0.1f});
  addDome(near, head, 0.12f * kPoppyRadius, 0.012f, 0.024f, 6, plant.leaf(0.6f), plant.leaf(1));
  made.near = near.finish();

  Builder far;
  addFlatStem(far, plant, 0.93f);
  for (int i = 0; i < 4; ++i) {
    const float turn = 0.25f * static_cast<float>(i), next = turn + 0.25f;
    const glm::vec3 normal = head.face * 0.8f - head.out(turn + 0.125f) * 0.4f;
    const Skin dark{plant.petal * 0.35f, 0.8f, 0.2f}, rim{plant.petal, 1, 1};
    const std::uint32_t foot = far.vertex(head.centre, normal, dark);
    const std::uint32_t a = far.vertex(head.at(turn, 0.92f * kPoppyRadius, 0.55f * kPoppyRadius), normal, rim);
    const std::uint32_t m = far.vertex(head.at(turn + 0.125f, kPoppyRadius, 0.62f * kPoppyRadius), normal, rim);
    const std::uint32_t c = far.vertex(head.at(next, 0.92f * kPoppyRadius, 0.55f * kPoppyRadius), normal, rim);
    far.triangle(foot, a, m);
    far.triangle(foot, m, c);
  }
  made.far = far.finish();
  return made;
}

// Spike.

/// Radius of the flowering part at `t` of its height, 0 below .. 1 tip.
float spikeRadius(float t) {
  return 0.046f * (1.0f - t) * (0.55f + 0.45f * std::min(1.0f, 6.0f * t)) + 0.008f;
}

void addFloret(Builder& b, const Plant& plant, float y, float t, float turn) {
  const float r = spikeRadius(t);
  const glm::vec3 root = Plant::spine(y), out = around(turn), side = around(turn + 0.25f);
  const glm::vec3 up(0, 1, 0);
  const glm::vec3 normal = out + 0.55f * up;
  const glm::vec3 deep = plant.petal * glm::mix(0.4f, 0.8f, t);
  const glm::vec3 light = glm::mix(plant.petal * 1.15f, glm::vec3(0.9f), 0.08f * (1 - t));
  const std::uint32_t a = b.vertex(root + out * (0.12f * r) + up * (0.30f * r), normal, {deep, 1, 0.1f});
  const std::uint32_t l = b.vertex(root + out * (0.72f * r) - side * (0.42f * r) + up * (0.22f * r),
                                   normal - 0.6f * side, {plant.petal, 1, 0.5f});
  const std::uint32_t d = b.vertex(root + out * (1.12f * r) - up * (0.30f * r), out - 0.1f * up, {light, 1, 0.8f});
  const std::uint32_t e = b.vertex(root + out * (0.72f * r) + side * (0.42f * r) + up * (0.22f * r),
                                   normal + 0.6f * side, {plant.petal, 1, 0.5f});
  b.quad(a, l, d, e);
}

FlowerMesh makeSpike(const Plant& plant) {
  constexpr float kFoot = 0.48f;
  constexpr int kFlorets = 66;
  FlowerMesh made;
  Builder near;
  addStem(near, plant, 0.99f, 3);
  for (int i = 0; i < 7; ++i) {
    const auto n = static_cast<float>(i);
    addLeaf(near, plant, 0.03f + 0.055f * n, kGoldenTurn * n + 0.2f, 0.22f - 0.014f * n, 0.016f, 1.0f);
  }
  for (int i = 0; i < kFlorets; ++i) {
    // Closer together towards the tip, where they are buds.
    const float t = std::pow(static_cast<float>(i) / kFlorets, 0.85f);
    const float turn = kGoldenTurn * static_cast<float>(i);
    addFloret(near, plant, glm::mix(kFoot, 0.99f, t), t, turn + 0.03f * std::sin(3.0f * static_cast<float>(i)));
  }
  made.near = near.finish();

  Builder far;
  addFlatStem(far, plant, 0.97f);
  // As much petal as near, with as much meadow seen between it.
  constexpr int kTufts = 8;
  for (int i = 0; i < kTufts; ++i) {
    const float t = (static_cast<float>(i) + 0.5f) / kTufts, turn = 0.13f + kGoldenTurn * static_cast<float>(i);
    const glm::vec3 side = around(turn), out = around(turn + 0.25f) + glm::vec3(0, 0.4f, 0);
    const glm::vec3 middle = Plant::spine(glm::mix(kFoot, 1.0f, t));
    const float r = 1.3f * spikeRadius(t), high = 0.038f;
    const Skin deep{plant.petal * 0.8f, 1, 0.2f}, light{glm::mix(plant.petal, glm::vec3(0.9f), 0.12f), 1, 0.5f};
    const std::uint32_t low = far.vertex(middle - glm::vec3(0, high, 0), out, deep),
                        left = far.vertex(middle - side * r, out, light),
                        right = far.vertex(middle + side * r, out, light),
                        top = far.vertex(middle + glm::vec3(0, high, 0), out, deep);
    far.quad(low, right, top, left);
  }
  made.far = far.finish();
  return made;
}

}  // namespace

FlowerMesh makeFlower(const Species& species) {
  const Plant plant(species);
  if (species.shape == PlantShape::Daisy) return makeDaisy(plant);
  if (species.shape == PlantShape::Poppy) return makePoppy(plant);
  WL_REQUIRE(species.shape == PlantShape::Spike, "the species is a built-in flower");
  return makeSpike(plant);
}

}  // namespace windloom
