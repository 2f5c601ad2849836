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

layout(std430, binding = RENDER_SSBO_CHUNKS) readonly buffer Chunks { GrassChunk chunks[]; };
layout(std430, binding = RENDER_SSBO_BLADES) readonly buffer Blades { GrassBlade blades[]; };
layout(std430, binding = RENDER_SSBO_COMMANDS) readonly buffer Commands { GrassCommands commands; };
uniform uint level;

out vec3 bladeColour;  // of the picture
#if SEGMENTS > 1
out vec3 bladePlace;  // -1..1 across, 0..1 along, how clearly the midrib is seen
#endif

struct Spine {
  vec3 position;  // from the root, m
  vec3 tangent;
};

Spine spineAt(GrassBlade blade, float s, vec2 facing, float height) {
  vec2 bend = unpackHalf2x16(blade.bend);
  Spine spine;
  if (grass.size.w != GRASS_DEFORMATION_QUADRATIC) {
    float angle = length(bend);
    vec2 towards = angle > 1e-5 ? bend / angle : facing;
    ArcPoint point = arcAt(min(angle, 1.54), s);
    spine.position = vec3(towards.x * point.position.x, point.position.y, towards.y * point.position.x) * height;
    spine.tangent = vec3(towards.x * point.tangent.x, point.tangent.y, towards.y * point.tangent.x);
    return spine;
  }
  // Blade-local x runs across the blade, z to its front.
  vec2 across = vec2(facing.y, -facing.x);
  vec2 local = vec2(dot(bend, across), dot(bend, facing));
  vec3 here = quadraticAt(vec3(0.0, s, 0.0), local, grass.droop.x, grass.droop.y, grass.motion.w);
  vec3 next = quadraticAt(vec3(0.0, s + 0.05, 0.0), local, grass.droop.x, grass.droop.y, grass.motion.w);
  vec3 step = next - here;
  spine.position = vec3(across.x * here.x + facing.x * here.z, here.y, across.y * here.x + facing.y * here.z) * height;
  spine.tangent = normalize(vec3(across.x * step.x + facing.x * step.z, step.y, across.y * step.x + facing.y * step.z) + vec3(0.0, 1e-5, 0.0));
  return spine;
}

float taperAt(float s) { return 1.0 - 0.9 * s * s; }

// Blades on a slope lean with it.
vec3 planted(vec3 v, vec3 normal) {
  if (groundIsFlat()) return v;
  vec3 up = normalize(mix(vec3(0.0, 1.0, 0.0), normal, grass.ground.x));
  vec3 axis = vec3(up.z, 0.0, -up.x);
  return v * up.y + cross(axis, v) + axis * (dot(axis, v) / (1.0 + up.y));
}

#if SEGMENTS > 1
vec3 litColour(GrassBlade blade, uint species, Spine spine, float s, vec3 n, vec3 towardsEdge, vec3 v, vec3 ground, float share) {
  vec2 shade = unpackHalf2x16(blade.shade);
  vec4 tint = unpackUnorm4x8(blade.tint);
  float height = unpackHalf2x16(blade.sizes).x;
  // How deep in the canopy: it bends down as a whole, so the place along the blade counts, not the height.
  float canopy = clamp(s * height / (grass.baseColour.w * min(share, 1.0)), 0.0, 1.0);
  // Where the meadow thins out at its margin blades stand in the open.
  canopy = mix(1.0, canopy, smoothstep(0.25, 0.7, share));
  GrassLight at;
  at.height = canopy;
  at.dense = grass.levels.z;
  at.sunlit = smoothstep(-0.15, 0.15, spine.position.y - shade.x);
  at.shade = heightWindShade(spine.position.y / height, shade.y) * mix(tint.a, 1.0, 0.5 * canopy);
  vec3 albedo = laidAlbedo(bladeAlbedo(species, s, tint.r, 2.0 * tint.g, 2.0 * tint.b - 1.0), spine.tangent);
  return lightBlade(albedo, normalize(n + 0.55 * towardsEdge), spine.tangent, v, at) + contourLift(ground, v, at.sunlit * at.height);
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
  float turn = 6.2831853 * (float(blade.facing & 2047u) + 0.5) / 2048.0;
  vec2 facing = vec2(cos(turn), sin(turn));
  uint species = blade.facing >> 11u & 31u;
  float rootHeight = mix(frame.groundRange.x, frame.groundRange.y, float(blade.facing >> 16u) / 65535.0);
  vec3 root = vec3(blade.x, rootHeight, blade.z);
  vec3 normal = groundNormal(root.xz);
  float tall = sizes.x * pixelsPerMetre(root);

  Spine spine = spineAt(blade, s, facing, sizes.x);
  float taper = SEGMENTS == 1 ? 1.3 * (1.0 - s) : taperAt(s);
#if SEGMENTS == 6
  float coarser = smoothstep(1.5 * grass.levels.x, grass.levels.x, tall);
  if (coarser > 0.0 && (row & 1) == 1) {
    Spine before = spineAt(blade, s - 1.0 / 6.0, facing, sizes.x);
    Spine after = spineAt(blade, s + 1.0 / 6.0, facing, sizes.x);
    spine.position = mix(spine.position, 0.5 * (before.position + after.position), coarser);
    float tipwards = row == 5 ? 0.0 : taperAt(s + 1.0 / 6.0);
    taper = mix(taper, 0.5 * (taperAt(s - 1.0 / 6.0) + tipwards), coarser);
  }
#elif SEGMENTS == 3
  float coarser = smoothstep(2.0 * grass.levels.y, grass.levels.y, tall);
  spine.position = mix(spine.position, spineAt(blade, 1.0, facing, sizes.x).position * s, coarser);
  taper = mix(taper, 1.3 * (1.0 - s), coarser);
#endif
  spine.position = planted(spine.position, normal);
  spine.tangent = planted(spine.tangent, normal);
  vec3 centre = root + spine.position;
  vec3 v = directionToCamera(centre);

  // A bent blade turns its face into the bend. Seen from its edge it is turned to the eye, so that it never
  // vanishes.
  vec2 bend = unpackHalf2x16(blade.bend);
  vec2 front = normalize(facing + 1.2 * bend * sign(dot(facing, bend) + 1e-4));
  vec3 side = vec3(front.y, 0.0, -front.x);
  side = normalize(side - 0.7 * v * dot(side, v));
  vec3 n = cross(side, spine.tangent);
  n = normalize(n);
  if (dot(n, v) < 0.0) n = -n;

  vec3 world = centre + side * (edge * 0.5 * sizes.y * taper);
  gl_Position = frame.viewProjection * vec4(world, 1.0);

  vec4 canopyShare = unpackUnorm4x8(blade.canopy);
  // From afar: the meadow's colour, darker at the foot and lighter at the tip.
  vec3 afar = canopyShare.yzw * mix(0.80, 1.14, s);
#if SEGMENTS == 1
  bladeColour = afar;
#else
  vec3 lit = litColour(blade, species, spine, s, n, side * edge, v, normal, canopyShare.x * 2.0);
  float single = grass.tileCentre.w > 0.5 ? 1.0 : 1.0 - smoothstep(2.2 * grass.levels.y, grass.levels.y, tall);
  bladeColour = mix(afar, toPicture(throughAir(lit, world)), single);
  float rib = 0.0;
#if SEGMENTS > 3
  rib = 1.0 - coarser;
#endif
  bladePlace = vec3(edge, s, rib);
#endif
}
