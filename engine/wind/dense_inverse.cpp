// Cholesky's decomposition of -A. A pocket of air without an open border leaves a constant free: adding a matrix of
// ones on it settles that, and changes nothing where the right-hand side sums to 0.
#include "engine/wind/dense_inverse.hpp"

#include <cmath>
#include <functional>

namespace windloom {
namespace {

using Index = std::size_t;

class Dense {
 public:
  explicit Dense(Index count) : m_count(count), m_values(count * count, 0.0) {}
  [[nodiscard]] double& at(Index row, Index column) { return m_values[row * m_count + column]; }
  [[nodiscard]] Index count() const { return m_count; }

 private:
  Index m_count;
  std::vector<double> m_values;
};

/// Calls visit(a, b, conductance) for every two cells that are linked.
void eachLink(const PressureLevel& level, const std::function<void(Index, Index, double)>& visit) {
  const Index w = static_cast<Index>(level.width), h = static_cast<Index>(level.height);
  for (Index k = 0; k < h; ++k) {
    for (Index i = 0; i < w; ++i) {
      const Index cell = k * w + i;
      const double x = double(level.cx[k * (w + 1) + i]), z = double(level.cz[k * w + i]);
      if (x > 0 && w > 1) visit(cell, i > 0 ? cell - 1 : cell + w - 1, x);
      if (z > 0 && h > 1) visit(cell, k > 0 ? cell - w : cell + (h - 1) * w, z);
    }
  }
}

/// Of each cell: the smallest cell that air reaches from it.
std::vector<Index> pocketsOf(const PressureLevel& level, Index count) {
  std::vector<Index> pocket(count);
  for (Index c = 0; c < count; ++c) pocket[c] = c;
  for (bool changed = true; changed;) {
    changed = false;
    eachLink(level, [&](Index a, Index b, double) {
      const Index least = std::min(pocket[a], pocket[b]);
      changed = changed || pocket[a] != least || pocket[b] != least;
      pocket[a] = pocket[b] = least;
    });
  }
  return pocket;
}

std::vector<double> groundOf(const PressureLevel& level, Index count) {
  const Index w = static_cast<Index>(level.width), h = static_cast<Index>(level.height);
  std::vector<double> ground(count, 0.0);
  for (Index k = 0; k < h; ++k) {
    ground[k * w] += double(level.groundX[2 * k]);
    ground[k * w + w - 1] += double(level.groundX[2 * k + 1]);
  }
  for (Index i = 0; i < w; ++i) {
    ground[i] += double(level.groundZ[2 * i]);
    ground[(h - 1) * w + i] += double(level.groundZ[2 * i + 1]);
  }
  return ground;
}

/// -A, made regular.
Dense matrixOf(const PressureLevel& level, Index count) {
  Dense a(count);
  const std::vector<double> ground = groundOf(level, count);
  eachLink(level, [&](Index p, Index q, double c) {
    a.at(p, p) += c;
    a.at(q, q) += c;
    a.at(p, q) -= c;
    a.at(q, p) -= c;
  });
  const std::vector<Index> pocket = pocketsOf(level, count);
  std::vector<double> pocketGround(count, 0.0);
  for (Index c = 0; c < count; ++c) {
    a.at(c, c) += ground[c];
    pocketGround[pocket[c]] += ground[c];
  }
  for (Index p = 0; p < count; ++p) {
    if (pocketGround[pocket[p]] > 0) continue;
    for (Index q = 0; q < count; ++q) {
      if (pocket[q] == pocket[p]) a.at(p, q) += 1.0;
    }
  }
  return a;
}

/// Replaces the lower triangle by Cholesky's.
void decompose(Dense& a) {
  for (Index j = 0; j < a.count(); ++j) {
    for (Index k = 0; k < j; ++k) a.at(j, j) -= a.at(j, k) * a.at(j, k);
    a.at(j, j) = std::sqrt(a.at(j, j));
    for (Index i = j + 1; i < a.count(); ++i) {
      for (Index k = 0; k < j; ++k) a.at(i, j) -= a.at(i, k) * a.at(j, k);
      a.at(i, j) /= a.at(j, j);
    }
  }
}

}  // namespace

std::vector<float> denseInverse(const PressureLevel& level) {
  const Index count = static_cast<Index>(level.width) * static_cast<Index>(level.height);
  Dense a = matrixOf(level, count);
  decompose(a);
  std::vector<float> inverse(count * count, 0.0f);
  std::vector<double> x(count);
  for (Index column = 0; column < count; ++column) {
    if (!(level.inverseDiagonal[column] > 0)) continue;
    for (Index i = 0; i < count; ++i) {
      x[i] = i == column ? 1.0 : 0.0;
      for (Index k = 0; k < i; ++k) x[i] -= a.at(i, k) * x[k];
      x[i] /= a.at(i, i);
    }
    for (Index i = count; i-- > 0;) {
      for (Index k = i + 1; k < count; ++k) x[i] -= a.at(k, i) * x[k];
      x[i] /= a.at(i, i);
    }
    for (Index i = 0; i < count; ++i) {
      if (level.inverseDiagonal[i] > 0) inverse[i * count + column] = static_cast<float>(-x[i]);
    }
  }
  return inverse;
}

}  // namespace windloom
