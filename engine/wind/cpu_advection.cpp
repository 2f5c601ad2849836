// Stam, Stable Fluids, 1999 (semi-Lagrangian); Selle, Fedkiw, Kim, Liu & Rossignac, An Unconditionally Stable
// MacCormack Method, 2008. Deviation: what is carried already has this step's forces, what carries it has not.
#include "engine/wind/cpu_advection.hpp"

#include <algorithm>
#include <cmath>

#include "engine/wind/cpu_borders.hpp"

namespace windloom {
namespace {

struct Corners {
  float a, b, c, d, tx, tz;
  [[nodiscard]] float value() const {
    const float low = a + (b - a) * tx, high = c + (d - c) * tx;
    return low + (high - low) * tz;
  }
};

/// The four entries around array position (x, z); beyond the ghosts lies what they hold.
Corners cornersAt(const CpuPlane& plane, float x, float z) {
  x = std::clamp(x, -1.0f, static_cast<float>(plane.width()));
  z = std::clamp(z, -1.0f, static_cast<float>(plane.height()));
  const int i = std::min(static_cast<int>(std::floor(x)), plane.width() - 1);
  const int k = std::min(static_cast<int>(std::floor(z)), plane.height() - 1);
  const float* low = plane.row(k) + i;
  const float* high = plane.row(k + 1) + i;
  return {low[0], low[1], high[0], high[1], x - static_cast<float>(i), z - static_cast<float>(k)};
}

float wrapped(float x, float period) { return x - period * std::floor(x / period); }

/// One axis of the field: where positions may go.
struct Axis {
  bool periodic;
  float length;     // cells
  float low, high;  // bounds for carried values: the field, one cell wider at open borders
  bool openLow, openHigh;

  [[nodiscard]] float inside(float x) const { return periodic ? wrapped(x, length) : std::clamp(x, 0.0f, length); }
  [[nodiscard]] float reach(float x) const { return periodic ? wrapped(x, length) : std::clamp(x, low, high); }
  [[nodiscard]] bool left(float x) const { return (openLow && x < 0) || (openHigh && x > length); }
};

Axis axisOf(int cells, Border low, Border high) {
  const float length = static_cast<float>(cells);
  const bool openLow = low == Border::Open, openHigh = high == Border::Open;
  return {low == Border::Periodic, length, openLow ? -1.0f : 0.0f, openHigh ? length + 1 : length, openLow, openHigh};
}

struct Tracer {
  const CpuVelocity& velocity;
  Axis x, z;
  float perX, perZ;  // cells a metre times the time step: velocity to cells a step

  explicit Tracer(const CpuFields& f)
      : velocity(f.velocity), x(axisOf(f.width(), f.grid.xMin, f.grid.xMax)), z(axisOf(f.height(), f.grid.zMin, f.grid.zMax)),
        perX(f.dt / f.grid.hx), perZ(f.dt / f.grid.hz) {}

  [[nodiscard]] glm::vec2 cellsAStep(float px, float pz) const {
    const float cx = x.inside(px), cz = z.inside(pz);
    return {cornersAt(velocity.u, cx, cz - 0.5f).value() * perX, cornersAt(velocity.w, cx - 0.5f, cz).value() * perZ};
  }
  /// Where the air at (px, pz) with velocity `own` (cells a step) is after `sign` steps, by the midpoint rule.
  [[nodiscard]] glm::vec2 trace(float px, float pz, glm::vec2 own, float sign) const {
    const glm::vec2 middle = cellsAStep(px + 0.5f * sign * own.x, pz + 0.5f * sign * own.y);
    return {px + sign * middle.x, pz + sign * middle.y};
  }
};

/// The velocity (cells a step) on the x-face or z-face with array entry (i, k).
glm::vec2 velocityOnFace(const Tracer& t, bool xFace, int i, int k) {
  const CpuPlane &u = t.velocity.u, &w = t.velocity.w;
  if (xFace) return {u.at(i, k) * t.perX, 0.25f * ((w.at(i - 1, k) + w.at(i, k)) + (w.at(i - 1, k + 1) + w.at(i, k + 1))) * t.perZ};
  return {0.25f * ((u.at(i, k - 1) + u.at(i + 1, k - 1)) + (u.at(i, k) + u.at(i + 1, k))) * t.perX, w.at(i, k) * t.perZ};
}

struct Pass {
  const Tracer& tracer;
  bool xFace;
  [[nodiscard]] float offsetX() const { return xFace ? 0.0f : 0.5f; }
  [[nodiscard]] float offsetZ() const { return xFace ? 0.5f : 0.0f; }

  [[nodiscard]] Corners read(const CpuPlane& plane, glm::vec2 place) const {
    return cornersAt(plane, tracer.x.reach(place.x) - offsetX(), tracer.z.reach(place.y) - offsetZ());
  }
  void predict(const CpuPlane& carried, int k, float* out) const {
    for (int i = 0; i < carried.width(); ++i) {
      const glm::vec2 own = velocityOnFace(tracer, xFace, i, k);
      out[i] = read(carried, tracer.trace(float(i) + offsetX(), float(k) + offsetZ(), own, -1)).value();
    }
  }
  void correct(const CpuPlane& carried, const CpuPlane& predicted, int k, float* out) const {
    const auto left = [&](glm::vec2 place) { return tracer.x.left(place.x) || tracer.z.left(place.y); };
    const float* q = carried.row(k);
    const float* first = predicted.row(k);
    for (int i = 0; i < carried.width(); ++i) {
      const glm::vec2 own = velocityOnFace(tracer, xFace, i, k);
      const float px = float(i) + offsetX(), pz = float(k) + offsetZ();
      const glm::vec2 back = tracer.trace(px, pz, own, -1), forth = tracer.trace(px, pz, own, 1);
      const Corners from = read(carried, back);
      const float returned = read(predicted, forth).value();
      const float lowest = std::min(std::min(from.a, from.b), std::min(from.c, from.d));
      const float highest = std::max(std::max(from.a, from.b), std::max(from.c, from.d));
      const float corrected = std::clamp(first[i] + 0.5f * (q[i] - returned), lowest, highest);
      out[i] = left(back) || left(forth) ? first[i] : corrected;
    }
  }
};

}  // namespace

void advect(CpuFields& f, ThreadPool& pool) {
  const Tracer tracer(f);
  const Pass onX{tracer, true}, onZ{tracer, false};
  forRowTasks(pool, f.height() + 1, [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      if (k < f.height()) onX.predict(f.forced.u, k, f.moved.u.row(k));
      onZ.predict(f.forced.w, k, f.moved.w.row(k));
    }
  });
  if (f.solver.advection == Advection::SemiLagrangian) return;
  fillGhosts(f, f.moved, OpenGhost::Ambient);
  forRowTasks(pool, f.height() + 1, [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k) {
      if (k < f.height()) onX.correct(f.forced.u, f.moved.u, k, f.corrected.u.row(k));
      onZ.correct(f.forced.w, f.moved.w, k, f.corrected.w.row(k));
    }
  });
  std::swap(f.moved, f.corrected);
}

}  // namespace windloom
