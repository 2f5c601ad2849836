#version 450 core
// Near: earth and old grass between the stems. Far, and where blades are drawn thinned: the mean colour of
// the meadow with the same wind in it, so that there is no seam where blades end.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/grass_tiles.glsl"
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

// What is left of single blades in the mean colour: tufts, finer the closer they are.
float tufts(vec2 world, float pixels) {
  float grain = noiseAt(world, 3.1).b + noiseAt(world, 11.0).a - 1.0;
  float fine = noiseAt(world.yx, 0.9).b + noiseAt(world, 0.37).a - 1.0;
  return 1.0 + 0.35 * grain + 0.5 * fine * smoothstep(15.0, 60.0, pixels);
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
  float mean = max(blended, smoothstep(0.15, 0.8, beyondField(world) / grass.tileOrigin.z));
  vec3 colour = vec3(0.0);
  if (mean < 1.0) colour = undergrowth(world, sunlit, open);
  if (mean > 0.0) {
    vec2 wind = rippledWind(world, smoothWind(world), grass.motion.z);
    vec3 meadow = meadowColour(world, wind, v, sunlit) * mix(open, 1.0, 0.5) * tufts(world, pixels);
    colour = mix(colour, meadow, mean);
  }
  writeScene(throughAir(colour, groundWorld));
}
