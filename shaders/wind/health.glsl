// Faces that aren't finite become the ambient wind and are counted. docs/solver.md section 2. Needs block.glsl and a
// buffer `control`.

// Counts `bad` faces of cell (i, k), or of the last cell; the smallest cell is kept, so that the report is always the
// same.
void reportUnhealthy(int i, int k, uint bad) {
  if (bad == 0u) return;
  atomicAdd(control.nonFinite, bad);
  atomicMin(control.firstNonFinite, uint(cellAt(min(i, wind.width - 1), min(k, wind.height - 1))));
}

float healed(float q, float ambient, inout uint bad) {
  if (isFinite(q)) return q;
  ++bad;
  return ambient;
}
