#include "leaf_shapes.hpp"

#include <cmath>

#include "maths.hpp"

namespace game {

namespace {

/// One half of a maple leaf's outline, from the stem to the tip.
const LeafCorner kMaple[] = {{0.00f, -0.22f, 1}, {0.11f, -0.32f, 1}, {0.18f, -0.25f, 1}, {0.34f, -0.25f, 1},
                             {0.28f, -0.13f, 1}, {0.25f, -0.06f, 1}, {0.38f, -0.02f, 1}, {0.50f, 0.10f, 1},
                             {0.41f, 0.13f, 1},  {0.40f, 0.23f, 1},  {0.27f, 0.16f, 1},  {0.15f, 0.10f, 1},
                             {0.21f, 0.25f, 1},  {0.14f, 0.29f, 1},  {0.09f, 0.34f, 1},  {0.00f, 0.50f, 1}};
constexpr int kSteps = 12;

/// Half the width of the other leaves, `part` of the way from the stem to the tip.
float halfWidth(int kind, float part) {
  if (kind == 1) return 0.27f * std::pow(std::sin(kPi * part), 0.85f);
  if (kind == 2) return 0.25f * std::sin(kPi * std::pow(part, 1.25f)) * (0.76f + 0.26f * std::cos(part * 8 * kPi));
  return 0.31f * std::sin(kPi * std::pow(part, 0.62f));
}

std::vector<LeafCorner> halfOutline(int kind) {
  if (kind == 0) return {std::begin(kMaple), std::end(kMaple)};
  std::vector<LeafCorner> outline;
  const int steps = kind == 2 ? 3 * kSteps / 2 : kSteps;
  for (int i = 0; i <= steps; ++i) {
    const float part = static_cast<float>(i) / static_cast<float>(steps);
    outline.push_back({i == 0 || i == steps ? 0 : halfWidth(kind, part), -0.34f + 0.84f * part, 1});
  }
  return outline;
}

}  // namespace

std::vector<LeafCorner> leafShape(int kind) {
  const std::vector<LeafCorner> half = halfOutline(kind);
  std::vector<LeafCorner> corners{{0, 0.02f, 0}, {-0.014f, -0.52f, 1}, {0.014f, -0.52f, 1}, {0.014f, half[0].y, 1}};
  corners.insert(corners.end(), half.begin() + 1, half.end());
  for (std::size_t i = half.size() - 2; i > 0; --i) corners.push_back({-half[i].x, half[i].y, 1});
  corners.push_back({-0.014f, half[0].y, 1});
  corners.push_back(corners[1]);
  return corners;
}

}  // namespace game
