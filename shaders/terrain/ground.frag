#version 450 core
// Near: earth and old grass between the stems. Far, and where blades are drawn thinned: the mean colour of
// the meadow with the same wind in it, so that there is no seam where blades end.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/scene_output.glsl"

in vec3 groundWorld;

vec3 undergrowth(vec2 world, float sunlit, float open) {
  vec4 fine = noiseAt(world, 1.7);
  vec4 mid = noiseAt(world.yx, 6.1);
  float litter = smoothstep(0.35, 0.7, 0.6 * fine.a + 0.4 * mid.r);
  vec3 low = mix(frame.groundColour.rgb, bladeAlbedo(0.35, 0.35, 1.0, 0.3), 0.35 + 0.45 * litter);
  low *= 0.65 + 0.7 * fine.b;
  float sun = sunInCanopy(0.12, grass.levels.z) * sunlit;
  vec3 light = frame.sunColour.rgb * max(frame.sunDirection.y, 0.0) * sun + frame.skyColour.rgb * mix(0.9, 0.3, grass.levels.z) * open;
  return low * light;
}

float insideMeadow(vec2 world) {
  vec2 high = frame.field.xy + frame.field.zw;
  vec2 beyond = max(max(frame.field.xy - world, world - high), vec2(0.0));
  return 1.0 - smoothstep(0.0, grass.tileOrigin.z, length(beyond));
}

void main() {
  vec2 world = groundWorld.xz;
  vec3 v = directionToCamera(groundWorld);
  float pixels = pixelsPerMetre(groundWorld);
  float solid = solidDistance(world);
  float sunlit = smoothstep(-0.1, 0.1, 0.02 - solidShadowHeight(world));
  float open = openness(solid);

  float tall = grass.baseColour.w * pixels;
  float blended = 1.0 - smoothstep(0.8, 6.0, tall / grass.cover.w);
  float field = insideMeadow(world);
  float mean = max(blended, 1.0 - field);
  vec3 colour = vec3(0.0);
  if (mean < 1.0) colour = undergrowth(world, sunlit, open);
  if (mean > 0.0) {
    vec2 wind = rippledWind(world, smoothWind(world), grass.motion.z);
    // Tufts: what is left of the blades' texture at this distance.
    float grain = noiseAt(world, 3.1).b + noiseAt(world, 11.0).a - 1.0;
    vec3 meadow = meadowColour(world, wind, v, sunlit) * mix(open, 1.0, 0.5) * (1.0 + 0.35 * grain);
    colour = mix(colour, meadow, mean);
  }
  writeScene(throughAir(colour, groundWorld));
}
