// What a face goes through after advection and viscosity: dissipation, health, speed limit, blocked faces.
// docs/solver.md section 2, points 4 and 5. Needs block.glsl and a buffer `control`.
#include "shaders/wind/health.glsl"

float settled(float q, float ambient, bool open, inout uint bad) {
  q = healed(ambient + (q - ambient) * wind.keep, ambient, bad);
  return open ? clamp(q, -wind.maxSpeed, wind.maxSpeed) : 0.0;
}
