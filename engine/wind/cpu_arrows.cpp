#include "engine/wind/cpu_arrows.hpp"

#include <algorithm>
#include <cmath>

#include "shaders/shared/wind_constants.h"

namespace windloom {
namespace {

/// Sums over the arrows for one row of cells.
struct RowSums {
  explicit RowSums(std::size_t cells)
      : rate(cells), targetX(cells), targetZ(cells), forceX(cells), forceZ(cells), swirlRate(cells), swirlX(cells), swirlZ(cells) {}
  std::vector<float> rate, targetX, targetZ;          // drive speed
  std::vector<float> forceX, forceZ;                  // drive force
  std::vector<float> swirlRate, swirlX, swirlZ;       // swirl
};

/// The cells of a row: centres (x, z), m, and velocities.
struct RowCells {
  int count;
  float xFirst, dx, z;
  const float* vx;
  const float* vz;
};

void addDrive(const ArrowForce& a, const RowCells& cells, RowSums& sums) {
  const glm::vec2 along = a.to - a.from;
  const float square = glm::dot(along, along);
  const float inverse = square > 0 ? 1 / square : 0.0f;
  const float sharpness = -2 / (a.radius * a.radius);
  const bool speedDrive = a.drive == ARROW_DRIVE_SPEED;
  const float rateAtCentre = std::min(std::abs(a.factor), 1.0f) / std::max(a.response, WIND_MIN_RESPONSE);
  for (int n = 0; n < cells.count; ++n) {
    const auto c = static_cast<std::size_t>(n);
    const float px = cells.xFirst + static_cast<float>(n) * cells.dx - a.from.x;
    const float pz = cells.z - a.from.y;
    const float t = std::clamp((px * along.x + pz * along.y) * inverse, 0.0f, 1.0f);
    const float ex = px - t * along.x, ez = pz - t * along.y;
    const float d2 = ex * ex + ez * ez;
    if (d2 >= a.radius * a.radius) continue;
    const float g = std::exp(sharpness * d2);
    if (speedDrive) {
      const float s = cells.vx[n] * a.direction.x + cells.vz[n] * a.direction.y;
      const float target = a.strength >= 0 ? std::max(s, a.strength) : std::min(s, a.strength);
      const float rate = g * rateAtCentre;
      sums.rate[c] += rate;
      sums.targetX[c] += rate * target * a.direction.x;
      sums.targetZ[c] += rate * target * a.direction.y;
    } else {
      sums.forceX[c] += g * a.strength * a.direction.x;
      sums.forceZ[c] += g * a.strength * a.direction.y;
    }
  }
}

void addSwirl(const ArrowForce& a, const RowCells& cells, RowSums& sums) {
  const float inverseSquare = 1 / (a.radius * a.radius);
  const float rateAtCentre = std::min(std::abs(a.factor), 1.0f) / std::max(a.response, WIND_MIN_RESPONSE);
  for (int n = 0; n < cells.count; ++n) {
    const auto c = static_cast<std::size_t>(n);
    const float ex = cells.xFirst + static_cast<float>(n) * cells.dx - a.to.x;
    const float ez = cells.z - a.to.y;
    const float d2 = ex * ex + ez * ez;
    if (d2 >= a.radius * a.radius || d2 <= 0) continue;
    const float d = std::sqrt(d2);
    const float g = std::exp(-2 * d2 * inverseSquare);
    const float profile = a.swirl * (2 * d / a.radius) * g * 1.6487213f;  // exp(1/2)
    const float tx = -ez / d, tz = ex / d;
    const float lacking = profile - (cells.vx[n] * tx + cells.vz[n] * tz);
    const float m = a.swirl >= 0 ? std::max(lacking, 0.0f) : std::min(lacking, 0.0f);
    const float rate = g * rateAtCentre;
    sums.swirlRate[c] += rate;
    sums.swirlX[c] += rate * m * tx;
    sums.swirlZ[c] += rate * m * tz;
  }
}

/// (1 - exp(-R dt)) / R: the time an exponential approach at rate R takes effect in a step.
float approach(float rate, float dt) { return rate * dt < 1e-4f ? dt : (1 - std::exp(-rate * dt)) / rate; }

}  // namespace

void arrowIncrements(const CpuFields& fields, CellBlock block, std::span<const ArrowForce> arrows,
                     std::span<const std::uint32_t> indices, CpuPlane& incrementX, CpuPlane& incrementZ) {
  const int count = block.iEnd - block.iBegin;
  const float dt = fields.dt;
  for (int k = block.kBegin; k < block.kEnd; ++k) {
    float* outX = incrementX.row(k) + block.iBegin;
    float* outZ = incrementZ.row(k) + block.iBegin;
    if (indices.empty()) {
      std::fill_n(outX, count, 0.0f);
      std::fill_n(outZ, count, 0.0f);
      continue;
    }
    const glm::vec2 first = cellCentreToWorld(glm::vec2(block.iBegin, k), fields.grid.mapping.minCorner, fields.grid.mapping.cellSize);
    const RowCells cells{count, first.x, fields.grid.hx, first.y, fields.speedX.row(k) + block.iBegin, fields.speedZ.row(k) + block.iBegin};
    RowSums sums(static_cast<std::size_t>(count));
    for (const std::uint32_t n : indices) {
      if (arrows[n].strength != 0) addDrive(arrows[n], cells, sums);
      if (arrows[n].swirl != 0) addSwirl(arrows[n], cells, sums);
    }
    for (int n = 0; n < count; ++n) {
      const auto c = static_cast<std::size_t>(n);
      const float pull = approach(sums.rate[c], dt), turn = approach(sums.swirlRate[c], dt);
      outX[n] = (sums.targetX[c] - sums.rate[c] * cells.vx[n]) * pull + sums.swirlX[c] * turn + dt * sums.forceX[c];
      outZ[n] = (sums.targetZ[c] - sums.rate[c] * cells.vz[n]) * pull + sums.swirlZ[c] * turn + dt * sums.forceZ[c];
    }
  }
}

}  // namespace windloom
