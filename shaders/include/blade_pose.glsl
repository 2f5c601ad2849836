// The pose of a blade in the wind, as blocks have it. Needs frame.glsl, noise.glsl, ground.glsl, wind_field.glsl, meadow.glsl,
// grass_tiles.glsl, solids.glsl, grass_maps.glsl, grass_blades.glsl, virtual_wind.glsl, blade_chain.glsl.

const float kMaxRestBend = 0.75;  // rad

struct BladePose {
  vec2 bend;         // as GrassBlade
  ChainLeans leans;  // of its segments over the bend
};

// Height of the canopy around a place over the mean one: lower in the meadow's margin.
float canopyAround(vec2 root, float margin) {
  float canopy = mix(1.0, 0.3, smoothstep(0.0, 0.8, margin)) * mapHeight(root);
  return canopy * (1.0 + 0.5 * grass.size.z * (noiseAtLevel(root, 13.0, 1.0).g - 0.5));
}

// m: lower beside solids, too, but whatever the camera sees of it.
float standingHeight(BladeRoot own) {
  return own.height * (0.6 + 0.4 * smoothstep(0.0, 0.5, solidsNear(own.root).distanceM)) * canopyAround(own.root, inMargin(own.root));
}

// `felt`: wind with its ripples.
BladePose blockPose(BladeRoot own, vec2 felt) {
  uint state = pcgHash(own.state ^ 0x1b873593u);
  BladePose pose;
  pose.leans.e = vec2[](vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0));
  pose.bend = felt * own.factor;
  if (grass.size.w == GRASS_DEFORMATION_QUADRATIC) return pose;
  // The droop of eq. 11 as a rest bend: k2 moves the tip forward by k2 of the height.
  vec2 rest = own.facing * min(grass.droop.y * 1.38 * (0.7 + 4.5 * unit(state) * unit(state)), kMaxRestBend);
  vec2 flutter = arcFlutter(felt, frame.viewForward.w, unit(state), 0.75 + 0.5 * unit(state), grass.motion.z);
  pose.bend = arcSteadyBend(rest, felt, own.factor) + flutter;
#ifdef CHAINS  // a software renderer would do both sides of a branch
  if (grass.size.w == GRASS_DEFORMATION_INERTIAL) {
    rest = arcSteadyBend(rest, vec2(0.0), 0.0);
    pose.leans = virtualLeans(own.root, rest, own.factor);
    pose.bend = rest + flutter;
  }
#endif
  return pose;
}

// From the world's axes into those of a blade planted on a slope; undoes planted() of blade.vert.
vec3 unplanted(vec3 v, vec3 normal) {
  if (groundIsFlat()) return v;
  vec3 up = normalize(mix(vec3(0.0, 1.0, 0.0), normal, grass.ground.x));
  vec3 axis = vec3(up.z, 0.0, -up.x);
  return v * up.y - cross(axis, v) + axis * (dot(axis, v) / (1.0 + up.y));
}
