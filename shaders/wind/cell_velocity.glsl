// Cell velocities and vorticity from the faces of the last step. Needs block.glsl and an array `velocity`.

vec2 cellVelocity(int i, int k) {
  return 0.5 * vec2(velocity[uAt(i, k)] + velocity[uAt(i + 1, k)], velocity[wAt(i, k)] + velocity[wAt(i, k + 1)]);
}

bool solidAt(int i, int k) {
  if (periodicX()) i = i < 0 ? i + wind.width : i >= wind.width ? i - wind.width : i;
  if (periodicZ()) k = k < 0 ? k + wind.height : k >= wind.height ? k - wind.height : k;
  if (i < 0 || k < 0 || i >= wind.width || k >= wind.height) return false;
  return (flagsOf(i, k) & WIND_SOLID) != 0u;
}

float nodeVorticity(int i, int k) {
  if (!periodicX() && (i == 0 || i == wind.width)) return 0.0;
  if (!periodicZ() && (k == 0 || k == wind.height)) return 0.0;
  if (solidAt(i - 1, k - 1) || solidAt(i, k - 1) || solidAt(i - 1, k) || solidAt(i, k)) return 0.0;
  return (velocity[wAt(i, k)] - velocity[wAt(i - 1, k)]) * wind.perHx -
         (velocity[uAt(i, k)] - velocity[uAt(i, k - 1)]) * wind.perHz;
}
