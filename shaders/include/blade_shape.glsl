// A blade's shape and light from its record. Needs frame.glsl, ground.glsl, wind_field.glsl, meadow.glsl, atmosphere.glsl,
// tone_map.glsl, blade_chain.glsl.

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

// What of a blade its light depends on.
struct BladeLook {
  uint species;
  float height;        // m
  float share;         // height of the canopy around it over the mean one
  float shadowHeight;  // m over the root
  float force;         // |F| of eq. 14
  vec4 tint;           // as GrassBlade
  vec3 ground;         // normal
  vec3 colour;         // factor
};

// Light of the picture at `s` along it; `place` from the root, `towardsEdge` in units of half its width.
vec3 bladeLight(BladeLook blade, vec3 place, vec3 tangent, float s, vec3 side, float edge, vec3 v) {
  vec3 n = normalize(cross(side, tangent));
  if (dot(n, v) < 0.0) n = -n;
  // How deep in the canopy: it bends down as a whole, so the place along the blade counts, not the height.
  float canopy = clamp(s * blade.height / (grass.baseColour.w * min(blade.share, 1.0)), 0.0, 1.0);
  // Where the meadow thins out at its margin blades stand in the open.
  canopy = mix(1.0, canopy, smoothstep(0.25, 0.7, blade.share));
  GrassLight at;
  at.height = canopy;
  at.dense = grass.levels.z;
  at.sunlit = smoothstep(-0.15, 0.15, place.y - blade.shadowHeight);
  at.shade = heightWindShade(place.y / blade.height, blade.force) * mix(blade.tint.a, 1.0, 0.5 * canopy);
  vec3 own = bladeAlbedo(blade.species, s, blade.tint.r, 2.0 * blade.tint.g, 2.0 * blade.tint.b - 1.0);
  vec3 albedo = laidAlbedo(own * blade.colour, tangent);
  // The cross-section is curved: the normal turns towards the edge.
  vec3 light = lightBlade(albedo, normalize(n + 0.55 * edge * side), tangent, v, at);
  return light + contourLift(blade.ground, v, at.sunlit * at.height);
}
