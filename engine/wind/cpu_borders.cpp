#include "engine/wind/cpu_borders.hpp"

#include <algorithm>

#include "shaders/shared/wind_constants.h"

namespace windloom {
namespace {

/// What a ghost beyond one border is made of: offset + factor * (the entry inside, or that of the other side).
struct GhostRule {
  float offset = 0, factor = 0;
  bool wrap = false;
};

GhostRule ruleOf(Border border, float ambient, OpenGhost open, const float* wallSpeed) {
  if (border == Border::Periodic) return {0, 1, true};
  if (border == Border::Wall) return wallSpeed ? GhostRule{2 * *wallSpeed, -1, false} : GhostRule{0, 1, false};
  return open == OpenGhost::Ambient ? GhostRule{ambient, 0, false} : GhostRule{0, 1, false};
}

/// `period` is the distance from an entry to its copy on the other side.
void ghostColumns(CpuPlane& plane, GhostRule low, GhostRule high, int period) {
  const int last = plane.width() - 1;
  for (int k = 0; k < plane.height(); ++k) {
    float* row = plane.row(k);
    const float lowSource = row[low.wrap ? period - 1 : 0];
    const float highSource = row[high.wrap ? last + 1 - period : last];
    row[-1] = low.offset + low.factor * lowSource;
    row[last + 1] = high.offset + high.factor * highSource;
  }
}

void ghostRows(CpuPlane& plane, GhostRule low, GhostRule high, int period) {
  const int last = plane.height() - 1;
  const float* lowSource = plane.row(low.wrap ? period - 1 : 0);
  const float* highSource = plane.row(high.wrap ? last + 1 - period : last);
  float* lowRow = plane.row(-1);
  float* highRow = plane.row(last + 1);
  for (int i = -1; i <= plane.width(); ++i) {
    lowRow[i] = low.offset + low.factor * lowSource[i];
    highRow[i] = high.offset + high.factor * highSource[i];
  }
}

/// One side of the field that lies across x or z.
struct Side {
  bool acrossX, high;
};

/// What an open border that the ambient wind enters by lets in at its normal face n. Air that the ambient wind itself
/// follows at once would let each face whose velocity is about 0, as in front of an obstacle, fall to one side: full
/// inflow or outflow, face by face. Where a stretch of the border lets in less air than the ambient wind brings, that
/// stretch moves as one and the ambient wind stays out.
float inflowAt(const CpuFields& f, Side side, int n) {
  const WindGrid& g = f.grid;
  const int count = side.acrossX ? g.height : g.width, line = side.high ? (side.acrossX ? g.width : g.height) : 0;
  const bool periodic = side.acrossX ? g.periodicZ() : g.periodicX();
  const float inward = side.high ? -1.0f : 1.0f, wanted = inward * (side.acrossX ? f.ambient.x : f.ambient.y);
  float sum = 0;
  int faces = 0;
  for (int m = n - WIND_INFLOW_REACH; m <= n + WIND_INFLOW_REACH; ++m) {
    const int face = periodic ? (m % count + count) % count : m;
    if (face < 0 || face >= count) continue;
    if (side.acrossX ? g.blockedX(line, face) : g.blockedZ(face, line)) continue;
    sum += side.acrossX ? f.velocity.u.at(line, face) : f.velocity.w.at(face, line);
    ++faces;
  }
  if (faces == 0) return inward * wanted;
  const float mean = inward * sum / static_cast<float>(faces), part = std::clamp(mean / wanted, 0.0f, 1.0f);
  return inward * (mean + part * part * (wanted - mean));
}

/// Ghosts of the normal component behind open borders that the ambient wind enters by.
void inflowColumns(const CpuFields& f, CpuPlane& u) {
  const WindGrid& g = f.grid;
  for (int k = 0; k < g.height; ++k) {
    if (g.xMin == Border::Open && f.ambient.x > 0) u.at(-1, k) = inflowAt(f, {true, false}, k);
    if (g.xMax == Border::Open && f.ambient.x < 0) u.at(g.width + 1, k) = inflowAt(f, {true, true}, k);
  }
}
void inflowRows(const CpuFields& f, CpuPlane& w) {
  const WindGrid& g = f.grid;
  for (int i = -1; i <= g.width; ++i) {
    if (g.zMin == Border::Open && f.ambient.y > 0) w.at(i, -1) = inflowAt(f, {false, false}, i);
    if (g.zMax == Border::Open && f.ambient.y < 0) w.at(i, g.height + 1) = inflowAt(f, {false, true}, i);
  }
}

template <class Predicate>
CpuRuns findRuns(int columns, int rows, Predicate inside) {
  CpuRuns result;
  result.start.push_back(0);
  for (int k = 0; k < rows; ++k) {
    for (int i = 0; i < columns; ++i) {
      if (!inside(i, k)) continue;
      if (!result.runs.empty() && result.runs.back().row == k && result.runs.back().end == i) {
        ++result.runs.back().end;
      } else {
        result.runs.push_back({k, i, i + 1});
      }
    }
    result.start.push_back(static_cast<int>(result.runs.size()));
  }
  return result;
}

void zeroRuns(const CpuRuns& runs, CpuPlane& plane) {
  for (const CpuRun& run : runs.runs) std::fill(plane.row(run.row) + run.begin, plane.row(run.row) + run.end, 0.0f);
}

}  // namespace

void fillGhosts(const CpuFields& fields, CpuVelocity& velocity, OpenGhost open) {
  const WindGrid& g = fields.grid;
  const auto wall = [&](float WallSpeeds::*side) { return fields.noSlip ? &((*fields.noSlip).*side) : nullptr; };
  const glm::vec2 a = fields.ambient;
  ghostColumns(velocity.u, ruleOf(g.xMin, a.x, open, nullptr), ruleOf(g.xMax, a.x, open, nullptr), g.width);
  if (open == OpenGhost::Ambient) inflowColumns(fields, velocity.u);
  ghostRows(velocity.u, ruleOf(g.zMin, a.x, open, wall(&WallSpeeds::zMin)),
            ruleOf(g.zMax, a.x, open, wall(&WallSpeeds::zMax)), g.height);
  ghostColumns(velocity.w, ruleOf(g.xMin, a.y, open, wall(&WallSpeeds::xMin)),
               ruleOf(g.xMax, a.y, open, wall(&WallSpeeds::xMax)), g.width);
  ghostRows(velocity.w, ruleOf(g.zMin, a.y, open, nullptr), ruleOf(g.zMax, a.y, open, nullptr), g.height);
  if (open == OpenGhost::Ambient) inflowRows(fields, velocity.w);
}

void findBlocked(CpuFields& fields) {
  const WindGrid& g = fields.grid;
  fields.blockedX = findRuns(g.width + 1, g.height, [&](int i, int k) { return g.blockedX(i, k); });
  fields.blockedZ = findRuns(g.width, g.height + 1, [&](int i, int k) { return g.blockedZ(i, k); });
  const auto solid = [&](int i, int k) {  // behind a border that isn't periodic: no cell
    if (g.periodicX()) i = (i + g.width) % g.width;
    if (g.periodicZ()) k = (k + g.height) % g.height;
    return i >= 0 && k >= 0 && i < g.width && k < g.height && g.solidAt(i, k);
  };
  fields.solidNodes = findRuns(g.width + 1, g.height + 1, [&](int i, int k) {
    return solid(i - 1, k - 1) || solid(i, k - 1) || solid(i - 1, k) || solid(i, k);
  });
}

void blockFaces(const CpuFields& fields, CpuVelocity& velocity) {
  zeroRuns(fields.blockedX, velocity.u);
  zeroRuns(fields.blockedZ, velocity.w);
  if (fields.grid.periodicX()) {
    for (int k = 0; k < fields.height(); ++k) velocity.u.at(fields.width(), k) = velocity.u.at(0, k);
  }
  if (fields.grid.periodicZ()) {
    std::copy_n(velocity.w.row(0), fields.width(), velocity.w.row(fields.height()));
  }
}

}  // namespace windloom
