#version 450 core
// A blade as a strip of SEGMENTS: row by row left and right, then the tip. An instance is a chunk of blades, the index says
// which of them and which vertex. Lit here, at its vertices: a blade is a few pixels wide. Towards the size where the next
// coarser strip takes over a strip takes on its shape, so that the change doesn't show.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/tone_map.glsl"
#include "shaders/include/blade_chain.glsl"
#include "shaders/include/blade_shape.glsl"
#include "shaders/include/blade_light.glsl"
#include "shaders/include/grass_maps.glsl"
#include "shaders/include/grass_tiles.glsl"

layout(std430, binding = RENDER_SSBO_CHUNKS) readonly buffer Chunks { GrassChunk chunks[]; };
layout(std430, binding = RENDER_SSBO_BLADES) readonly buffer Blades { GrassBlade blades[]; };
layout(std430, binding = RENDER_SSBO_COMMANDS) readonly buffer Commands { GrassCommands commands; };
layout(std430, binding = RENDER_SSBO_CHAINS) readonly buffer Chains { uvec4 chains[]; };
uniform uint level;

out vec3 bladeColour;  // of the picture
#if SEGMENTS > 1
out vec3 bladePlace;  // -1..1 across, 0..1 along, how clearly the midrib is seen
#endif

float taperAt(float s) { return 1.0 - 0.9 * s * s; }

#if SEGMENTS > 1
// Light at a place of its spine. `hidden`: part of the blades around it that it stands for.
vec3 litAt(BladeLook look, Spine spine, float s, vec3 side, float edge, vec3 v, float hidden) {
  float seen = mix(s, 1.0 - seenDepth(v.y) * (1.0 - s), hidden);
  vec3 place = spine.position + vec3(0.0, (seen - s) * look.height, 0.0);
  return bladeLight(look, place.y, spine.tangent, seen, side, edge, v, vec3(0.0, 1.0, 0.0));
}
#endif

#if SEGMENTS == 6 && !defined(QUICK)
vec3 pictureAt(BladeLook look, vec3 root, Spine spine, float s, vec2 bend, vec2 facing, float edge, float hidden) {
  vec3 place = root + spine.position;
  vec3 v = directionToCamera(place);
  return toPicture(throughAir(litAt(look, spine, s, bladeSide(bend, facing, v), edge, v, hidden), place));
}
#endif

void main() {
  uint at = uint(gl_VertexID);
  uint chunk = commands.starts[level] + uint(gl_InstanceID);
  uint lane = at >> 4u;
  int vertex = int(at & 15u);
  if (lane >= chunks[chunk].count) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    bladeColour = vec3(0.0);
#if SEGMENTS > 1
    bladePlace = vec3(0.0);
#endif
    return;
  }
  GrassBlade blade = blades[chunk * GRASS_CHUNK + lane];
  int row = vertex / 2;
  float s = float(row) / float(SEGMENTS);
  float edge = row == SEGMENTS ? 0.0 : (vertex & 1) == 0 ? -1.0 : 1.0;
  vec2 sizes = unpackHalf2x16(blade.sizes);
  vec2 facing = facingOf(blade.facing);
  vec2 bend = unpackHalf2x16(blade.bend);
#ifdef QUICK  // neither chains nor the change between strips
  const bool chained = false;
  ChainLeans leans;
#else
  bool chained = blade.chain != 0u;
  uvec4 packed4 = chained ? chains[chunk * GRASS_CHUNK + lane] : uvec4(0u);
  ChainLeans leans = ChainLeans(vec2[](unpackHalf2x16(packed4.x), unpackHalf2x16(packed4.y), unpackHalf2x16(packed4.z), unpackHalf2x16(packed4.w)));
#endif
  float rootHeight = mix(frame.groundRange.x, frame.groundRange.y, float(blade.facing >> 16u) / 65535.0);
  vec3 root = vec3(blade.x, rootHeight, blade.z);
  vec3 normal = groundNormal(root.xz);
  float tall = grass.baseColour.w * pixelsPerMetre(root);

  Spine spine = spineAt(bend, chained, leans, s, facing, sizes.x);
  float taper = SEGMENTS == 1 ? 1.3 * (1.0 - s) : taperAt(s);
#ifdef QUICK
  const float coarser = 0.0;
#elif SEGMENTS == 6
  float coarser = grass.tileCentre.w > 0.5 ? 0.0 : smoothstep(1.5 * grass.levels.x, grass.levels.x, tall);
  bool between = coarser > 0.0 && (row & 1) == 1;
  Spine before = spine, after = spine;
  if (between) {
    before = spineAt(bend, chained, leans, s - 1.0 / 6.0, facing, sizes.x);
    after = spineAt(bend, chained, leans, s + 1.0 / 6.0, facing, sizes.x);
    spine.position = mix(spine.position, 0.5 * (before.position + after.position), coarser);
    float tipwards = row == 5 ? 0.0 : taperAt(s + 1.0 / 6.0);
    taper = mix(taper, 0.5 * (taperAt(s - 1.0 / 6.0) + tipwards), coarser);
  }
#elif SEGMENTS == 3
  float coarser = smoothstep(2.0 * grass.levels.y, grass.levels.y, tall);
  spine.position = mix(spine.position, spineAt(bend, chained, leans, 1.0, facing, sizes.x).position * s, coarser);
  taper = mix(taper, 1.3 * (1.0 - s), coarser);
#endif
  spine.position = planted(spine.position, normal);
  spine.tangent = planted(spine.tangent, normal);
  vec3 centre = root + spine.position;
  vec3 v = directionToCamera(centre);

  vec3 side = bladeSide(bend, facing, v);
  vec3 world = centre + side * (edge * 0.5 * sizes.y * taper);
  gl_Position = frame.viewProjection * vec4(world, 1.0);

  vec4 foot = unpackUnorm4x8(blade.foot);
  vec4 tip = unpackUnorm4x8(blade.tip);
  vec3 afar = mix(foot.rgb, tip.rgb, s);
#if SEGMENTS == 1
  bladeColour = afar;
#else
  vec2 shade = unpackHalf2x16(blade.shade);
  BladeLook look = BladeLook(speciesOf(blade.facing), sizes.x, canopyOf(2.0 * foot.a), closedOf(2.0 * foot.a), shade.x, shade.y, unpackUnorm4x8(blade.tint), normal, mapColour(root.xz));
  vec3 lit = toPicture(throughAir(litAt(look, spine, s, side, edge, v, tip.a), world));
#if SEGMENTS == 6 && !defined(QUICK)
  if (between) {
    Spine low = Spine(planted(before.position, normal), planted(before.tangent, normal));
    Spine high = Spine(planted(after.position, normal), planted(after.tangent, normal));
    // Between its ends the coarser strip has the mean of what they show, not of their light.
    vec3 below = pictureAt(look, root, low, s - 1.0 / 6.0, bend, facing, edge, tip.a);
    vec3 above = pictureAt(look, root, high, s + 1.0 / 6.0, bend, facing, row == 5 ? 0.0 : edge, tip.a);
    lit = mix(lit, 0.5 * (below + above), coarser);
  }
#endif
  float clear = smoothstep(grass.levels.y, 2.0 * grass.levels.y, tall);
  bladeColour = mix(afar, lit, clear);
  float rib = 0.0;
#if SEGMENTS > 3
  rib = 1.0 - coarser;
#endif
  bladePlace = vec3(edge, s, rib);
#endif
}
