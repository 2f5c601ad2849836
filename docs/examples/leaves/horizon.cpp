#include "horizon.hpp"

namespace game {

namespace {

/// Height of a ridge all round: waves that close after a whole turn.
float ridge(float angle, float phase) {
  return 0.5f + 0.22f * std::sin(3 * angle + phase) + 0.14f * std::sin(7 * angle + 2.1f * phase) +
         0.09f * std::sin(13 * angle + 3.7f * phase) + 0.03f * std::sin(41 * angle + phase) +
         0.02f * std::sin(89 * angle + 5 * phase);
}

Vec3 around(float angle, float height) {
  return {std::cos(angle), height, std::sin(angle)};
}

struct Tree {
  Vec3 foot;
  float wide, high;  // m
  Vec3 colour;
};

/// A ball of leaves that faces the meadow: a fan with an uneven rim, light from above.
void addBall(Vec3 middle, Vec3 across, float size, Vec3 colour, Random& random, std::vector<WoodCorner>& corners) {
  constexpr int kRim = 7;
  WoodCorner rim[kRim + 1];
  const float turn = random.between(-1, 1);
  for (int i = 0; i < kRim; ++i) {
    const float angle = turn + 2 * kPi * static_cast<float>(i) / kRim;
    const float out = size * random.between(0.75f, 1.1f);
    rim[i] = {middle + across * (out * std::cos(angle)) + Vec3{0, out * std::sin(angle), 0},
              colour * (1 + 0.45f * std::sin(angle))};
  }
  rim[kRim] = rim[0];
  for (int i = 0; i < kRim; ++i) corners.insert(corners.end(), {{middle, colour}, rim[i], rim[i + 1]});
}

/// A crown of a few balls, dark ones below and light ones above.
void addTree(const Tree& tree, Random& random, std::vector<WoodCorner>& corners) {
  constexpr int kBalls = 6;
  const Vec3 across = normalized(cross({0, 1, 0}, tree.foot), {1, 0, 0});
  for (int i = 0; i < kBalls; ++i) {
    const float up = static_cast<float>(i) / (kBalls - 1);
    const float aside = random.between(-1, 1) * (1 - 0.8f * up);
    const Vec3 middle =
        tree.foot + across * (0.75f * tree.wide * aside) + Vec3{0, tree.high * mix(0.12f, 0.82f, up), 0};
    addBall(middle, across, tree.wide * mix(0.8f, 0.45f, up), tree.colour * mix(0.45f, 1.15f, up), random, corners);
  }
}

}  // namespace

std::vector<HillCorner> hills(std::uint32_t seed) {
  constexpr int kPieces = 360;
  struct Layer {
    float low, high, haze;
    Vec3 colour;
  };
  const Layer layers[] = {{0.030f, 0.085f, 0.72f, {0.16f, 0.25f, 0.36f}},
                          {0.018f, 0.052f, 0.52f, {0.15f, 0.22f, 0.22f}}};
  std::vector<HillCorner> corners;
  float phase = static_cast<float>(seed % 100);
  for (const Layer& layer : layers) {
    phase += 1.9f;
    for (int i = 0; i < kPieces; ++i) {
      HillCorner quad[4];
      for (int side = 0; side < 2; ++side) {
        const float angle = 2 * kPi * static_cast<float>(i + side) / kPieces;
        const float top = mix(layer.low, layer.high, ridge(angle, phase));
        quad[side] = {around(angle, -0.004f), layer.colour, 1};  // out of the mist
        quad[side + 2] = {around(angle, top), layer.colour, layer.haze};
      }
      corners.insert(corners.end(), {quad[0], quad[1], quad[2], quad[2], quad[1], quad[3]});
    }
  }
  return corners;
}

std::vector<WoodCorner> wood(const Bounds& meadow, std::uint32_t seed) {
  constexpr int kTrees = 480;
  const Vec3 colours[] = {{0.34f, 0.15f, 0.02f}, {0.38f, 0.24f, 0.03f}, {0.26f, 0.09f, 0.02f}, {0.13f, 0.17f, 0.03f},
                          {0.09f, 0.14f, 0.04f}, {0.40f, 0.29f, 0.05f}, {0.16f, 0.19f, 0.04f}, {0.20f, 0.18f, 0.04f}};
  Random random(seed + 31);
  const float size = std::max(meadow.width(), meadow.depth()) / 100;
  const Vec3 centre{(meadow.minX + meadow.maxX) / 2, 0, (meadow.minZ + meadow.maxZ) / 2};
  std::vector<Tree> trees;
  for (int i = 0; i < kTrees; ++i) {
    const float angle = random.between(0, 2 * kPi);
    const float away = mix(420, 340, static_cast<float>(i) / kTrees) * size + random.between(-8, 8) * size;
    const float high = random.between(11, 19) * size * (0.75f + 0.5f * ridge(angle, 4));
    const Vec3 colour = colours[static_cast<int>(random.unit() * std::size(colours))] * random.between(0.9f, 1.4f);
    trees.push_back(
        {around(angle, 0) * away - Vec3{0, 1.5f * size, 0}, high * random.between(0.36f, 0.5f), high, colour});
  }
  std::vector<WoodCorner> corners;
  for (Tree& tree : trees) addTree(tree, random, corners);
  for (WoodCorner& corner : corners) corner.position += centre;
  return corners;
}

}  // namespace game
