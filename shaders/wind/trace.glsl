// Following the air through the velocity field. docs/solver.md section 4. Positions are in cell units. Needs block.glsl
// and an array `velocity` with its ghosts.

// Entry and weights of bilinear interpolation on an array of `count` entries with one ghost on each side.
void bilinear(vec2 place, ivec2 count, out ivec2 low, out vec2 t) {
  place = clamp(place, vec2(-1.0), vec2(count));
  low = min(ivec2(floor(place)), count - 1);
  t = place - vec2(low);
}

float blend(vec4 corners, vec2 t) {  // (low, low), (high, low), (low, high), (high, high)
  vec2 rows = corners.xz + (corners.yw - corners.xz) * t.x;
  return rows.x + (rows.y - rows.x) * t.y;
}

#define CORNERS(array, at) vec4(array[at], array[(at) + 1], array[(at) + wind.stride], array[(at) + wind.stride + 1])

vec2 wrapPlace(vec2 place, vec2 size) {
  if (periodicX()) place.x -= size.x * floor(place.x / size.x);
  if (periodicZ()) place.y -= size.y * floor(place.y / size.y);
  return place;
}

// Where the carrying velocity is read for a position: inside the field.
vec2 insideField(vec2 place) {
  vec2 size = vec2(wind.width, wind.height);
  return clamp(wrapPlace(place, size), vec2(0.0), size);
}

bvec4 openSides() {
  return bvec4(wind.xMin == WIND_BORDER_OPEN, wind.zMin == WIND_BORDER_OPEN, wind.xMax == WIND_BORDER_OPEN,
               wind.zMax == WIND_BORDER_OPEN);
}

// Where carried values are read: one cell further out at open borders.
vec2 withinReach(vec2 place) {
  vec2 size = vec2(wind.width, wind.height);
  bvec4 open = openSides();
  return clamp(wrapPlace(place, size), -vec2(open.xy), size + vec2(open.zw));
}

bool leftField(vec2 place) {
  bvec4 open = openSides();
  return (open.x && place.x < 0.0) || (open.y && place.y < 0.0) || (open.z && place.x > float(wind.width)) ||
         (open.w && place.y > float(wind.height));
}

// Whether a position and everything that is interpolated around it lies inside the field. False for what isn't a
// number.
bool isDeepInside(vec2 place) {
  return min(place.x, place.y) >= 1.0 && place.x <= float(wind.width - 1) && place.y <= float(wind.height - 1);
}
// Bilinear interpolation there needs no care: low corner and weights.
ivec2 plainCorner(vec2 place, out vec2 t) {
  vec2 low = floor(place);
  t = place - low;
  return ivec2(low);
}

// Cells a step.
vec2 carryingVelocity(vec2 place) {
  ivec2 low, lowZ;
  vec2 t, tz;
  if (isDeepInside(place)) {
    low = plainCorner(place - vec2(0.0, 0.5), t);
    lowZ = plainCorner(place - vec2(0.5, 0.0), tz);
  } else {
    vec2 inside = insideField(place);
    bilinear(inside - vec2(0.0, 0.5), ivec2(wind.width + 1, wind.height), low, t);
    bilinear(inside - vec2(0.5, 0.0), ivec2(wind.width, wind.height + 1), lowZ, tz);
  }
  float u = blend(CORNERS(velocity, uAt(low.x, low.y)), t);
  float w = blend(CORNERS(velocity, wAt(lowZ.x, lowZ.y)), tz);
  return vec2(u * (wind.dt * wind.perHx), w * (wind.dt * wind.perHz));
}

// Midpoint rule: where the air at `place`, with velocity `own` there, is after `sign` steps.
vec2 trace(vec2 place, vec2 own, float sign) { return place + sign * carryingVelocity(place + (0.5 * sign) * own); }

// Cells a step on x-face and z-face (i, k).
vec2 velocityOnX(int i, int k) {
  float low = velocity[wAt(i - 1, k)] + velocity[wAt(i, k)];
  float w = 0.25 * (low + (velocity[wAt(i - 1, k + 1)] + velocity[wAt(i, k + 1)]));
  return vec2(velocity[uAt(i, k)] * (wind.dt * wind.perHx), w * (wind.dt * wind.perHz));
}
vec2 velocityOnZ(int i, int k) {
  float low = velocity[uAt(i, k - 1)] + velocity[uAt(i + 1, k - 1)];
  float u = 0.25 * (low + (velocity[uAt(i, k)] + velocity[uAt(i + 1, k)]));
  return vec2(u * (wind.dt * wind.perHx), velocity[wAt(i, k)] * (wind.dt * wind.perHz));
}

// Index and weights for reading a carried array at a position.
int carriedU(vec2 place, out vec2 t) {
  ivec2 low;
  if (isDeepInside(place)) {
    low = plainCorner(place - vec2(0.0, 0.5), t);
    return uAt(low.x, low.y);
  }
  bilinear(withinReach(place) - vec2(0.0, 0.5), ivec2(wind.width + 1, wind.height), low, t);
  return uAt(low.x, low.y);
}
int carriedW(vec2 place, out vec2 t) {
  ivec2 low;
  if (isDeepInside(place)) {
    low = plainCorner(place - vec2(0.5, 0.0), t);
    return wAt(low.x, low.y);
  }
  bilinear(withinReach(place) - vec2(0.5, 0.0), ivec2(wind.width, wind.height + 1), low, t);
  return wAt(low.x, low.y);
}
