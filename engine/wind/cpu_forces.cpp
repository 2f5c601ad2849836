// Vorticity confinement: Fedkiw, Stam & Jensen, Visual Simulation of Smoke, 2001. Deviation: bounded by the local speed.
#include "engine/wind/cpu_forces.hpp"

#include <algorithm>
#include <cmath>

#include "engine/wind/cpu_arrows.hpp"
#include "engine/wind/cpu_borders.hpp"

namespace windloom {
namespace {

/// Vorticity at the nodes of row k (0..H), out[0..W].
void nodeVorticity(const CpuFields& f, int k, float* out) {
  const WindGrid& g = f.grid;
  const float ix = 1 / g.hx, iz = 1 / g.hz;
  if ((k == 0 || k == g.height) && !g.periodicZ()) {
    std::fill_n(out, g.width + 1, 0.0f);
    return;
  }
  const float* w = f.velocity.w.row(k);
  const float* uLow = f.velocity.u.row(k - 1);
  const float* uHigh = f.velocity.u.row(k);
  for (int i = 0; i <= g.width; ++i) out[i] = (w[i] - w[i - 1]) * ix - (uHigh[i] - uLow[i]) * iz;
  if (!g.periodicX()) out[0] = out[g.width] = 0;
  for (const CpuRun& run : runsOf(f.solidNodes, k)) std::fill(out + run.begin, out + run.end, 0.0f);
}

/// Adds the confinement of row k of cells, whose nodes have the vorticities `low` and `high`.
void addConfinement(const CpuFields& f, int k, const float* low, const float* high, float* incX, float* incZ) {
  const float h = std::sqrt(f.grid.hx * f.grid.hz);
  const float scale = f.dt * f.solver.confinement * h;
  const float halfX = 0.5f / f.grid.hx, halfZ = 0.5f / f.grid.hz;
  const float tiny = 1e-5f / h, soft = 0.25f * WIND_CONFINEMENT_SOFTNESS * std::sqrt(2 * (halfX * halfX + halfZ * halfZ));
  const float *vx = f.speedX.row(k), *vz = f.speedZ.row(k);
  const float *vxLow = f.speedX.row(k - 1), *vzLow = f.speedZ.row(k - 1);
  const float *vxHigh = f.speedX.row(k + 1), *vzHigh = f.speedZ.row(k + 1);
  for (int i = 0; i < f.width(); ++i) {
    const float a = std::abs(low[i]), b = std::abs(low[i + 1]), c = std::abs(high[i]), d = std::abs(high[i + 1]);
    const float etaX = ((b + d) - (a + c)) * halfX, etaZ = ((c + d) - (a + b)) * halfZ;
    const float omega = ((low[i] + low[i + 1]) + (high[i] + high[i + 1])) * 0.25f;
    const float blur = soft * ((a + b) + (c + d)) + tiny;
    const float push = scale * omega / (std::sqrt(etaX * etaX + etaZ * etaZ) + blur);
    float dx = push * etaZ, dz = -push * etaX;
    const float own = vx[i] * vx[i] + vz[i] * vz[i];
    const float size = dx * dx + dz * dz;
    const float allowed = WIND_CONFINEMENT_LIMIT * WIND_CONFINEMENT_LIMIT * own;
    const float cut = size > allowed ? std::sqrt(allowed / size) : 1.0f;
    dx *= cut;
    dz *= cut;
    const float sides = std::max(vx[i - 1] * vx[i - 1] + vz[i - 1] * vz[i - 1], vx[i + 1] * vx[i + 1] + vz[i + 1] * vz[i + 1]);
    const float ends = std::max(vxLow[i] * vxLow[i] + vzLow[i] * vzLow[i], vxHigh[i] * vxHigh[i] + vzHigh[i] * vzHigh[i]);
    const float fastest = std::max(own, std::max(sides, ends));
    const float nx = vx[i] + dx, nz = vz[i] + dz;
    const float reached = nx * nx + nz * nz;
    const float keep = reached > fastest ? std::sqrt(fastest / reached) : 1.0f;
    incX[i] += nx * keep - vx[i];
    incZ[i] += nz * keep - vz[i];
  }
}

void addGusts(const CpuFields& f, int k, const std::array<WindGustLayer, WIND_GUST_LAYERS>& layers, float* incX, float* incZ) {
  const float part = 1 - std::exp(-f.dt / WIND_GUST_RESPONSE);
  const float fade = 1 / (4 * f.gustAmplitude * f.gustAmplitude);
  const float *vx = f.speedX.row(k), *vz = f.speedZ.row(k);
  for (int i = 0; i < f.width(); ++i) {
    const glm::vec2 place = cellCentreToWorld(glm::vec2(i, k), f.grid.mapping.minCorner, f.grid.mapping.cellSize);
    const glm::vec2 lacking = f.ambient + f.gustAmplitude * gustAt(f.gustTable, layers, place) - glm::vec2(vx[i], vz[i]);
    const float weight = part / (1 + glm::dot(lacking, lacking) * fade);
    incX[i] += weight * lacking.x;
    incZ[i] += weight * lacking.y;
  }
}

/// Increments of cell rows [begin, end) apart from the arrows', which are already there.
void addFieldForces(CpuFields& f, int begin, int end, const std::array<WindGustLayer, WIND_GUST_LAYERS>& layers) {
  const bool confine = f.solver.confinement > 0;
  std::vector<float> low(static_cast<std::size_t>(f.width()) + 1), high(low.size());
  if (confine) nodeVorticity(f, begin, high.data());
  for (int k = begin; k < end; ++k) {
    float* incX = f.moved.u.row(k);
    float* incZ = f.moved.w.row(k);
    if (f.gustAmplitude > 0) addGusts(f, k, layers, incX, incZ);
    if (!confine) continue;
    low.swap(high);
    nodeVorticity(f, k + 1, high.data());
    addConfinement(f, k, low.data(), high.data(), incX, incZ);
  }
}

void addToRowX(const CpuFields& f, int k, const float* increment, float* out) {
  const int w = f.width();
  const float* u = f.velocity.u.row(k);
  for (int i = 1; i < w; ++i) out[i] = u[i] + 0.5f * (increment[i - 1] + increment[i]);
  const bool periodic = f.grid.periodicX();
  out[0] = u[0] + (periodic ? 0.5f * (increment[w - 1] + increment[0]) : increment[0]);
  out[w] = periodic ? out[0] : u[w] + increment[w - 1];
}

void addToRowZ(const CpuFields& f, int k, const CpuPlane& increments, float* out) {
  const int h = f.height();
  const bool periodic = f.grid.periodicZ();
  const float* w = f.velocity.w.row(k);
  const float* low = increments.row(k > 0 ? k - 1 : periodic ? h - 1 : 0);
  const float* high = increments.row(k < h ? k : periodic ? 0 : h - 1);
  for (int i = 0; i < f.width(); ++i) out[i] = w[i] + 0.5f * (low[i] + high[i]);
}

}  // namespace

void applyForces(CpuFields& f, ThreadPool& pool, std::span<const ArrowForce> arrows, const ArrowTiles& tiles, double time) {
  const auto layers = gustLayersAt(f.ambientSettings, time);
  const int side = tiles.cellsPerSide;
  pool.parallelFor(tiles.rows, [&](int b) {
    const int kBegin = b * side, kEnd = std::min(f.height(), kBegin + side);
    for (int a = 0; a < tiles.columns; ++a) {
      const auto t = static_cast<std::size_t>(b * tiles.columns + a);
      const auto indices = std::span(tiles.indices).subspan(tiles.start[t], tiles.start[t + 1] - tiles.start[t]);
      arrowIncrements(f, {a * side, std::min(f.width(), (a + 1) * side), kBegin, kEnd}, arrows, indices, f.moved.u, f.moved.w);
    }
    addFieldForces(f, kBegin, kEnd, layers);
  });
  forRowTasks(pool, f.height() + 1, [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      if (k < f.height()) addToRowX(f, k, f.moved.u.row(k), f.forced.u.row(k));
      addToRowZ(f, k, f.moved.w, f.forced.w.row(k));
    }
  });
}

}  // namespace windloom
