// What a face goes through after advection and viscosity: dissipation, health, speed limit, blocked faces.
// docs/solver.md section 2, points 4 and 5. Needs block.glsl and a buffer `control`.

// Counts the cell of a face that isn't finite; the smallest one is kept, so that the report is always the same.
void reportUnhealthy(int i, int k) {
  atomicAdd(control.nonFinite, 1u);
  atomicMin(control.firstNonFinite, uint(cellAt(min(i, wind.width - 1), min(k, wind.height - 1))));
}

float settled(float q, float ambient, bool open, inout bool healthy) {
  q = ambient + (q - ambient) * wind.keep;
  if (!isFinite(q)) {
    healthy = false;
    q = ambient;
  }
  return open ? clamp(q, -wind.maxSpeed, wind.maxSpeed) : 0.0;
}
