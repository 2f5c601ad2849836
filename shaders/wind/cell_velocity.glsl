// Cell velocities and vorticity from the faces of the last step. Needs block.glsl and an array `velocity`.

vec2 cellVelocity(int i, int k) {
  return 0.5 * vec2(velocity[uAt(i, k)] + velocity[uAt(i + 1, k)], velocity[wAt(i, k)] + velocity[wAt(i, k + 1)]);
}

float nodeVorticity(int i, int k) {
  if (!periodicX() && (i == 0 || i == wind.width)) return 0.0;
  if (!periodicZ() && (k == 0 || k == wind.height)) return 0.0;
  // Node (i, k) is the low corner of cell (i, k); behind a periodic border that is a cell of the other side.
  if ((flagsOf(i == wind.width ? 0 : i, k == wind.height ? 0 : k) & WIND_SOLID_NODE) != 0u) return 0.0;
  return (velocity[wAt(i, k)] - velocity[wAt(i - 1, k)]) * wind.perHx -
         (velocity[uAt(i, k)] - velocity[uAt(i, k - 1)]) * wind.perHz;
}
