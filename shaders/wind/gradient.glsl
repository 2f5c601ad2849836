// Taking a pressure gradient off the four faces of a cell. Needs block.glsl.

// q: faces x low, x high, z low, z high; p: the cell's pressure; around: that of its neighbours in the same order. A face
// that would not be finite keeps its value.
vec4 withoutGradient(vec4 q, uint flags, float p, vec4 around) {
  vec4 rise = vec4((flags & WIND_LINK_X_LOW) != 0u ? p - around.x : (flags & WIND_GROUND_X_LOW) != 0u ? 2.0 * p : 0.0,
                   (flags & WIND_LINK_X_HIGH) != 0u ? around.y - p : (flags & WIND_GROUND_X_HIGH) != 0u ? -2.0 * p : 0.0,
                   (flags & WIND_LINK_Z_LOW) != 0u ? p - around.z : (flags & WIND_GROUND_Z_LOW) != 0u ? 2.0 * p : 0.0,
                   (flags & WIND_LINK_Z_HIGH) != 0u ? around.w - p : (flags & WIND_GROUND_Z_HIGH) != 0u ? -2.0 * p : 0.0);
  vec4 next = q - rise * vec4(wind.perHx, wind.perHx, wind.perHz, wind.perHz);
  return vec4(finiteOr(next.x, q.x), finiteOr(next.y, q.y), finiteOr(next.z, q.z), finiteOr(next.w, q.w));
}
