// Taking a pressure gradient off the four faces of a cell. Needs block.glsl.

// From what lies behind a side to the cell's pressure p, across one cell: a neighbour, the ground half a cell away, or
// nothing.
float riseTo(float p, float neighbour, uint flags, uint link, uint ground) {
  return (flags & link) != 0u ? p - neighbour : (flags & ground) != 0u ? 2.0 * p : 0.0;
}

// q: faces x low, x high, z low, z high; p: the cell's pressure; around: that of its neighbours in the same order. A
// face that would not be finite keeps its value. All pressures are parts of `scale`.
vec4 withoutGradient(vec4 q, uint flags, float p, vec4 around, float scale) {
  vec4 rise = vec4(riseTo(p, around.x, flags, WIND_LINK_X_LOW, WIND_GROUND_X_LOW),
                   -riseTo(p, around.y, flags, WIND_LINK_X_HIGH, WIND_GROUND_X_HIGH),
                   riseTo(p, around.z, flags, WIND_LINK_Z_LOW, WIND_GROUND_Z_LOW),
                   -riseTo(p, around.w, flags, WIND_LINK_Z_HIGH, WIND_GROUND_Z_HIGH));
  vec4 next = q - rise * (scale * vec4(wind.perHx, wind.perHx, wind.perHz, wind.perHz));
  return vec4(finiteOr(next.x, q.x), finiteOr(next.y, q.y), finiteOr(next.z, q.z), finiteOr(next.w, q.w));
}
