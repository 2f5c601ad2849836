// The pose of a blade in the wind, as blocks have it. Needs frame.glsl, noise.glsl, ground.glsl, wind_field.glsl, meadow.glsl,
// grass_tiles.glsl, solids.glsl, grass_blades.glsl, virtual_wind.glsl.

const float kMaxRestBend = 0.75;  // rad

struct BladePose {
  vec2 bend;         // as GrassBlade
  ChainLeans leans;  // of its segments over the bend
};

// `state`: of the blade's random numbers, after those for margin and width; takes four of them. `felt`: wind with its ripples.
BladePose blockPose(BladeRoot own, inout uint state, vec2 felt) {
  BladePose pose;
  pose.leans.e = vec2[](vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0));
  pose.bend = felt * own.factor;
  if (grass.size.w == GRASS_DEFORMATION_QUADRATIC) return pose;
  // The droop of eq. 11 as a rest bend: k2 moves the tip forward by k2 of the height.
  vec2 rest = own.facing * min(grass.droop.y * 1.38 * (0.7 + 4.5 * unit(state) * unit(state)), kMaxRestBend);
  vec2 flutter = arcFlutter(felt, frame.viewForward.w, unit(state), 0.75 + 0.5 * unit(state), grass.motion.z);
  if (grass.size.w == GRASS_DEFORMATION_INERTIAL) {
    rest = arcSteadyBend(rest, vec2(0.0), 0.0);
    pose.leans = virtualLeans(own.root, rest, own.factor);
    pose.bend = rest + flutter;
  } else {
    pose.bend = arcSteadyBend(rest, felt, own.factor) + flutter;
  }
  return pose;
}

// A point of the pose at `s` of the blade before the leans, from its root, in blade heights.
vec3 posePoint(vec2 bend, vec2 facing, float s) {
  if (grass.size.w == GRASS_DEFORMATION_QUADRATIC) {
    vec2 across = vec2(facing.y, -facing.x);
    vec3 at = quadraticAt(vec3(0.0, s, 0.0), vec2(dot(bend, across), dot(bend, facing)), grass.droop.x, grass.droop.y, grass.motion.w);
    return vec3(across.x * at.x + facing.x * at.z, at.y, across.y * at.x + facing.y * at.z);
  }
  float angle = length(bend);
  vec2 towards = angle > 1e-5 ? bend / angle : facing;
  ArcPoint at = arcAt(min(angle, 1.54), s);
  return vec3(towards.x * at.position.x, at.position.y, towards.y * at.position.x);
}

// From the world's axes into those of a blade planted on a slope; undoes planted() of blade.vert.
vec3 unplanted(vec3 v, vec3 normal) {
  if (groundIsFlat()) return v;
  vec3 up = normalize(mix(vec3(0.0, 1.0, 0.0), normal, grass.ground.x));
  vec3 axis = vec3(up.z, 0.0, -up.x);
  return v * up.y - cross(axis, v) + axis * (dot(axis, v) / (1.0 + up.y));
}
