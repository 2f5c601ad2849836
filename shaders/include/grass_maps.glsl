// Pictures laid over the field that change the meadow, and slopes too steep for it. Needs frame.glsl, meadow.glsl. Neutral where
// there is no map; beyond the field a map fades out, so that its edge doesn't run on to the horizon.

layout(binding = RENDER_TEXTURE_DENSITY_MAP) uniform sampler2D densityMap;
layout(binding = RENDER_TEXTURE_HEIGHT_MAP) uniform sampler2D heightMap;
layout(binding = RENDER_TEXTURE_COLOUR_MAP) uniform sampler2D colourMap;

vec2 mapPlace(vec2 world) { return (world - frame.field.xy) / frame.field.zw; }

const float kMapFadeM = 14.0;

// 1 in the field, 0 far from it.
float mapReach(vec2 world) {
  vec2 high = frame.field.xy + frame.field.zw;
  return 1.0 - smoothstep(0.0, kMapFadeM, length(max(max(frame.field.xy - world, world - high), vec2(0.0))));
}

// The byte 128 is mid grey and changes nothing, 255 doubles.
vec3 aroundGrey(vec3 value) {
  vec3 bytes = value * 255.0;
  return mix(bytes / 128.0, 1.0 + (bytes - 128.0) / 127.0, step(128.0, bytes));
}

float mapLuma(vec3 colour) { return dot(colour, vec3(0.2126, 0.7152, 0.0722)); }

// Part of the plants that grow, 0..1.
float mapDensity(vec2 world) { return mix(1.0, mapLuma(textureLod(densityMap, mapPlace(world), 0.0).rgb), mapReach(world)); }

// Factor of their height, 0..2.
float mapHeight(vec2 world) { return mix(1.0, aroundGrey(vec3(mapLuma(textureLod(heightMap, mapPlace(world), 0.0).rgb))).r, mapReach(world)); }

// Factor of their colour, 0..2 in each channel.
vec3 mapColour(vec2 world) { return mix(vec3(1.0), aroundGrey(textureLod(colourMap, mapPlace(world), 0.0).rgb), mapReach(world)); }

// Part of the plants that grow on ground with this normal, 0..1.
float slopeDensity(vec3 normal) { return smoothstep(grass.ground.y, grass.ground.z, normal.y); }
