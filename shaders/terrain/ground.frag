#version 450 core
// Near: earth and old grass between the stems. Far, and where blades are drawn thinned: the mean colour of
// the meadow with the same wind in it, so that there is no seam where blades end.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/grass_tiles.glsl"
#include "shaders/include/solids.glsl"
#ifndef PLAIN  // without maps and colliders
#include "shaders/include/grass_maps.glsl"
#include "shaders/include/colliders.glsl"
#endif
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/scene_output.glsl"

in vec3 groundWorld;

// What is left of single blades in the mean colour, finer the closer they are.
float tufts(vec2 world, vec4 fine, vec4 mid, float pixels) {
  float grain = 0.35 * (mid.a + fine.b - 1.0);
#ifdef FULL_DETAIL
  vec4 close = noiseAt(world.yx, 0.61);
  grain += 0.45 * (close.a + close.b - 1.0) * smoothstep(15.0, 60.0, pixels);
#endif
  return 1.0 + grain;
}

void main() {
  vec2 world = groundWorld.xz;
  vec3 v = directionToCamera(groundWorld);
  float pixels = pixelsPerMetre(groundWorld);
  SolidsNear solids = solidsNear(world);
  GroundLight slope = groundLight(world, pixels);
  float sunlit = smoothstep(-0.1, 0.1, 0.02 - max(solids.shadowHeight, softened(slope.shadowHeight)));
  float light = slopeLight(slope.normal, sunlit);
  float open = openness(solids.distanceM);
#ifdef FULL_DETAIL
  vec4 fine = noiseAt(world, 1.9);
  vec4 mid = noiseAt(world.yx, 8.3);
#else
  // From one level of the texture, not between two.
  vec4 fine = noiseAtLevel(world, 1.9, floor(log2(256.0 / (1.9 * pixels)) + 0.5));
  vec4 mid = fine.gbar;
#endif

  float tall = grass.baseColour.w * pixels;
  // As far as fewer blades cover it than grow there.
  float covered = keptByHeight(tall, grass.cover.w) * min(grass.cover.y * grass.size.x * pixels / grass.cover.x, 1.0);
  covered *= 1.0 - hiddenPart(dot(slope.normal, v));
  float blended = grass.tileCentre.w > 0.5 ? 0.0 : 1.0 - covered;
  // Under shells that fade out it is there already.
  if (grass.tileCentre.w > 1.5) blended = 1.0 - smoothstep(1.6 * grass.cover.w, 3.0 * grass.cover.w, tall);
  float mean = max(blended, smoothstep(0.15, 0.8, beyondField(world) / grass.tileCentre.z));
  mean *= smoothstep(grass.ground.y, grass.ground.z, slope.normal.y);
#ifndef PLAIN
  mean *= mapDensity(world);
  light *= colliderShade(groundWorld);
#endif
#ifdef FULL_DETAIL
  vec2 wind = rippledWind(world, smoothWind(world), grass.motion.z);
#else
  vec2 wind = smoothWind(world);
#endif
  vec3 meadow = meadowColour(world, wind, v, slope.normal, sunlit) * mix(open, 1.0, 0.5) * tufts(world, fine, mid, pixels);
#ifndef PLAIN
  meadow *= mapColour(world);
#endif
  float litter = smoothstep(0.35, 0.7, 0.6 * fine.a + 0.4 * mid.r);
  vec3 ground = undergrowth(litter, 0.65 + 0.7 * fine.b, sunlit, open);
  writeScene(throughAir(mix(ground, meadow, mean) * light, groundWorld));
}
