// Light of one blade. Needs frame.glsl, noise.glsl, wind_field.glsl, meadow.glsl.

// What of a blade its light depends on.
struct BladeLook {
  uint species;
  float height;        // m
  float canopy;        // m: how high the canopy around it is
  float closed;        // 0 it stands in the open .. 1 among others
  float shadowHeight;  // m over the root
  float force;         // |F| of eq. 14
  vec4 tint;           // as GrassBlade
  vec3 ground;         // normal
  vec3 colour;         // factor
};

// Of a meadow whose canopy has `share` of the mean height; where it thins out at its margin blades stand in the open.
float canopyOf(float share) { return grass.baseColour.w * min(share, 1.0); }
float closedOf(float share) { return smoothstep(0.25, 0.7, share); }

// Factor of a dandelion's colour: a pale seed head at its end.
vec3 dandelionColour(vec3 colour, float v) {
  return mix(colour, vec3(0.75, 0.73, 0.66) / max(grass.tipColour.rgb, vec3(0.02)), smoothstep(0.85, 0.93, v));
}

// Light of the picture at `s` along it; `rise` m over its root, `edge` in units of half its width, `up` where it grows to.
vec3 bladeLight(BladeLook blade, float rise, vec3 tangent, float s, vec3 side, float edge, vec3 v, vec3 up) {
  vec3 n = normalize(cross(side, tangent));
  if (dot(n, v) < 0.0) n = -n;
  // How deep in the canopy: it bends down as a whole, so the place along the blade counts, not the height.
  float canopy = mix(1.0, clamp(s * blade.height / blade.canopy, 0.0, 1.0), blade.closed);
  GrassLight at;
  at.height = canopy;
  at.dense = grass.levels.z;
  at.sunlit = smoothstep(-0.15, 0.15, rise - blade.shadowHeight);
  at.shade = heightWindShade(rise / blade.height, blade.force) * mix(blade.tint.a, 1.0, 0.5 * canopy);
  vec3 own = bladeAlbedo(blade.species, s, blade.tint.r, 2.0 * blade.tint.g, 2.0 * blade.tint.b - 1.0);
  vec3 albedo = laidAlbedo(own * blade.colour, dot(tangent, up));
  // The cross-section is curved: the normal turns towards the edge.
  vec3 light = lightBlade(albedo, normalize(n + 0.55 * edge * side), tangent, v, up, at);
  return light + contourLift(blade.ground, v, at.sunlit * at.height);
}
