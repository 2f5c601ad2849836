// How a plant that isn't a blade stands at a moment. Needs frame.glsl, noise.glsl, wind_field.glsl.

// Its lean in still air (direction times angle of the tip, rad); `phase` in 0..1 is its own.
vec2 plantRest(float phase) {
  float lean = 6.2831853 * phase;
  return vec2(cos(lean), sin(lean)) * (0.03 + 0.16 * fract(7.31 * phase));
}

// What it moves around its steady bend by. `felt` is the wind at its root with its ripples.
vec2 plantFlutter(vec2 felt, float phase, float flutter) {
  return 0.6 * arcFlutter(felt, frame.viewForward.w, phase, 0.6 + 0.4 * fract(3.7 * phase), flutter);
}

struct PlantPoint {
  vec3 position;  // from the root, m
  vec3 normal;
};

// A point of the plant's mesh, given in metres about its root, and its normal, in the pose. The part at height y turns
// with the stem there.
PlantPoint posed(vec3 at, vec3 normal, float height, vec2 bend) {
  float angle = length(bend);
  if (angle < 1e-5) return PlantPoint(at, normal);
  vec2 towards = bend / angle;
  float s = at.y / height;
  ArcPoint arc = arcAt(min(angle, 1.54), clamp(s, 0.0, 1.0));
  float beyond = (s - clamp(s, 0.0, 1.0)) * height;
  vec2 along = arc.position * height + arc.tangent * beyond;
  float out_ = dot(at.xz, towards);
  // Turned by the stem's angle: what lay along the bend tips down, what lay across stays.
  vec2 moved = along + out_ * vec2(arc.tangent.y, -arc.tangent.x);
  vec2 aside = at.xz - out_ * towards;
  float nOut = dot(normal.xz, towards);
  vec2 turned = nOut * vec2(arc.tangent.y, -arc.tangent.x) + normal.y * arc.tangent;
  vec2 nAside = normal.xz - nOut * towards;
  return PlantPoint(vec3(towards * moved.x + aside, moved.y).xzy, vec3(towards * turned.x + nAside, turned.y).xzy);
}
