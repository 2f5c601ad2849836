// How things that stand or move in the meadow take light. Needs frame.glsl, noise.glsl, ground.glsl, solids.glsl.

struct Surface {
  vec3 albedo;
  vec3 normal;  // in the world
  float gloss;  // how strongly the sun is mirrored
};

// Noise over a surface with this normal, from three sides.
vec4 grain(vec3 own, vec3 n, float size) {
  vec3 part = n * n * n * n;
  part /= part.x + part.y + part.z;
  return part.x * noiseAt(own.zy + 3.7, size) + part.y * noiseAt(own.xz, size) + part.z * noiseAt(own.xy + 7.1, size);
}

// Sun, sky and what the meadow around throws back. `v`: unit vector to the camera.
vec3 objectLight(Surface surface, vec3 world, vec3 v) {
  float above = world.y - groundHeight(world.xz);
  // Deep in the grass less light arrives.
  float foot = smoothstep(0.0, 0.5, above);
  float shadow = smoothstep(-0.2, 0.2, above - solidsNear(world.xz).shadowHeight);
  shadow *= smoothstep(-0.5, 0.0, above - groundLight(world.xz, 0.0).shadowHeight);
  vec3 n = surface.normal;
  vec3 l = frame.sunDirection.xyz;
  float sun = shadow * mix(0.55, 1.0, foot);
  vec3 light = frame.sunColour.rgb * max(dot(n, l), 0.0) * sun;
  light += frame.skyColour.rgb * (0.55 + 0.45 * n.y) * mix(0.45, 1.0, foot);
  light += frame.sunColour.rgb * vec3(0.035, 0.045, 0.015) * (0.5 - 0.5 * n.y);
  float mirrored = pow(max(dot(n, normalize(v + l)), 0.0), 24.0) * step(0.0, dot(n, l));
  float edge = pow(1.0 - clamp(dot(n, v), 0.0, 1.0), 5.0);
  vec3 sheen = frame.sunColour.rgb * mirrored * sun + frame.skyColour.rgb * edge * foot;
  return surface.albedo * light + surface.gloss * sheen;
}
