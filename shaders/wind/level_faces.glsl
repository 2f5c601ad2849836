// How a level of the pressure solve keeps its conductances: node (i, k) of (width + 1) x (height + 1) holds those of
// the low faces of cell (i, k), x and z, as half floats and as parts of a whole face's. A border face holds the conductance
// to the ground behind it: what lies there has d = 0.

vec2 facesOf(uint node) { return unpackHalf2x16(node); }

// One over the sum of a cell's conductances; 0 for a cell without any.
float inverseOf(float sum) { return sum > 0.0 ? 1.0 / sum : 0.0; }

// Reciprocal Chebyshev points of [WIND_SMOOTH_FROM, 2]; the way up begins with the last.
float smoothingWeight(int m) {
  const float middle = 0.5 * (2.0 + WIND_SMOOTH_FROM), reach = 0.5 * (2.0 - WIND_SMOOTH_FROM);
  return 1.0 / (middle + reach * cos(3.14159265 * float(2 * m + 1) / float(2 * WIND_SWEEPS_UP)));
}
