#include "engine/model/hare_shape.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

/// Smooth minimum: rounds the crease between two bodies over about `soft` m (Quilez, "smooth minimum", 2013).
double blended(double a, double b, double soft) {
  const double near = std::max(soft - std::abs(a - b), 0.0) / soft;
  return std::min(a, b) - near * near * near * soft / 6.0;
}

double carved(double body, double tool, double soft) {
  return -blended(-body, tool, soft);
}

/// Turned about z by `degrees`, from +x towards +y.
glm::dvec3 turned(glm::dvec3 p, double degrees) {
  const double angle = glm::radians(degrees), c = std::cos(angle), s = std::sin(angle);
  return {c * p.x + s * p.y, c * p.y - s * p.x, p.z};
}

double ellipsoid(glm::dvec3 p, glm::dvec3 radii) {
  const double whole = glm::length(p / radii), slope = glm::length(p / (radii * radii));
  return slope < 1e-9 ? -std::min({radii.x, radii.y, radii.z}) : whole * (whole - 1.0) / slope;
}

/// A limb from `a` to `b` with a radius at each end.
double limb(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, double ra, double rb) {
  const glm::dvec3 way = b - a;
  const double t = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
  return glm::distance(p, a + way * t) - glm::mix(ra, rb, t);
}

double trunk(glm::dvec3 p) {
  double d = ellipsoid(turned(p - glm::dvec3(-0.145, 0.215, 0.0), 20.0), {0.215, 0.190, 0.165});            // rump
  d = blended(d, ellipsoid(turned(p - glm::dvec3(0.00, 0.32, 0.0), 52.0), {0.235, 0.150, 0.140}), 0.10);    // back
  d = blended(d, ellipsoid(turned(p - glm::dvec3(0.095, 0.335, 0.0), 75.0), {0.165, 0.110, 0.115}), 0.09);  // chest
  d = blended(d, limb(p, {0.085, 0.43, 0.0}, {0.155, 0.585, 0.0}, 0.098, 0.078), 0.08);                     // neck
  return blended(d, ellipsoid(p - glm::dvec3(-0.355, 0.155, 0.0), {0.072, 0.062, 0.060}), 0.025);           // tail
}

/// Of one side: z is its distance from the middle.
double legs(glm::dvec3 p) {
  double d = ellipsoid(turned(p - glm::dvec3(-0.085, 0.185, 0.118), 28.0), {0.165, 0.135, 0.075});  // thigh
  d = blended(d, limb(p, {-0.13, 0.045, 0.135}, {0.105, 0.036, 0.150}, 0.044, 0.036), 0.045);       // hind foot
  d = blended(d, ellipsoid(p - glm::dvec3(0.105, 0.036, 0.150), {0.055, 0.036, 0.042}), 0.03);      // its toes
  double arm = limb(p, {0.125, 0.33, 0.070}, {0.195, 0.055, 0.062}, 0.062, 0.033);
  arm = blended(arm, ellipsoid(p - glm::dvec3(0.222, 0.032, 0.062), {0.052, 0.032, 0.037}), 0.03);
  return blended(d, arm, 0.04);
}

double head(glm::dvec3 p) {
  double d = ellipsoid(turned(p - glm::dvec3(0.205, 0.625, 0.0), -14.0), {0.122, 0.094, 0.086});
  d = blended(d, ellipsoid(turned(p - glm::dvec3(0.292, 0.595, 0.0), -14.0), {0.062, 0.052, 0.052}), 0.05);  // muzzle
  d = blended(d, ellipsoid(p - glm::dvec3(0.225, 0.588, 0.048), {0.070, 0.052, 0.050}), 0.04);               // cheek
  d = blended(d, ellipsoid(p - glm::dvec3(0.350, 0.607, 0.0), {0.016, 0.013, 0.020}), 0.012);                // nose
  d = carved(d, ellipsoid(p - glm::dvec3(0.236, 0.652, 0.098), {0.036, 0.030, 0.026}), 0.02);                // socket
  return blended(d, ellipsoid(p - glm::dvec3(0.236, 0.650, 0.070), {0.024, 0.024, 0.018}), 0.006);           // eye
}

/// Leans back and outwards, its hollow to the front.
double ear(glm::dvec3 p) {
  glm::dvec3 q = p - glm::dvec3(0.165, 0.680, 0.042);
  q = turned(q, 17.0);
  const double out = glm::radians(13.0);
  q = {q.x, std::cos(out) * q.y + std::sin(out) * q.z, std::cos(out) * q.z - std::sin(out) * q.y};
  const double round = glm::radians(28.0);  // the hollows look a little to the sides
  q = {std::cos(round) * q.x + std::sin(round) * q.z, q.y, std::cos(round) * q.z - std::sin(round) * q.x};
  const double d = ellipsoid(q - glm::dvec3(0.0, 0.165, 0.0), {0.034, 0.195, 0.060});
  return carved(d, ellipsoid(q - glm::dvec3(0.036, 0.180, 0.0), {0.026, 0.150, 0.036}), 0.02);
}

}  // namespace

double hareField(glm::dvec3 place) {
  const glm::dvec3 p(place.x, place.y, std::abs(place.z));
  double d = blended(trunk(p), legs(p), 0.05);
  d = blended(d, head(p), 0.05);
  return blended(d, ear(p), 0.025);
}

}  // namespace windloom
