// A blade's shape from its record. Needs frame.glsl, ground.glsl, wind_field.glsl, meadow.glsl, blade_chain.glsl.

struct Spine {
  vec3 position;  // from the root, m
  vec3 tangent;
};

vec2 facingOf(uint bits) {
  float turn = 6.2831853 * (float(bits & 2047u) + 0.5) / 2048.0;
  return vec2(cos(turn), sin(turn));
}

uint speciesOf(uint bits) { return bits >> 11u & 31u; }

// `chained`: its segments lean over the bend.
Spine spineAt(vec2 bend, bool chained, ChainLeans leans, float s, vec2 facing, float height) {
  Spine spine;
  if (chained) {
    leaningPoint(bend, leans, facing, s, spine.position, spine.tangent);
    spine.position *= height;
  } else {
    spine.position = posePoint(bend, facing, s) * height;
    spine.tangent = poseTangent(bend, facing, s);
  }
  return spine;
}

// Blades on a slope lean with it.
vec3 planted(vec3 v, vec3 normal) {
  if (groundIsFlat()) return v;
  vec3 up = normalize(mix(vec3(0.0, 1.0, 0.0), normal, grass.ground.x));
  vec3 axis = vec3(up.z, 0.0, -up.x);
  return v * up.y + cross(axis, v) + axis * (dot(axis, v) / (1.0 + up.y));
}

// Across the blade where it is seen from `v`. A bent blade turns its face into the bend. Seen from its edge it is turned
// to the eye, so that it never vanishes.
vec3 bladeSide(vec2 bend, vec2 facing, vec3 v) {
  vec2 front = normalize(facing + 1.2 * bend * sign(dot(facing, bend) + 1e-4));
  vec3 side = vec3(front.y, 0.0, -front.x);
  return normalize(side - 0.7 * v * dot(side, v));
}
