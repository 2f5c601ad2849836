#version 450 core
// A blade as a strip of SEGMENTS: row by row left and right, then the tip. Lit here, at its vertices: a
// blade is a few pixels wide.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/tone_map.glsl"

layout(std430, binding = RENDER_SSBO_BLADES) readonly buffer Blades { GrassBlade blades[]; };
uniform uint listStart;

out vec3 bladeColour;  // of the picture
#if SEGMENTS > 1
out vec2 bladePlace;  // -1..1 across, 0..1 along
#endif

struct Spine {
  vec3 position;  // from the root, m
  vec3 tangent;
};

Spine spineAt(GrassBlade blade, float s, vec2 facing, float height) {
  vec2 bend = unpackHalf2x16(blade.bend);
  Spine spine;
  if (grass.size.w == GRASS_DEFORMATION_ARC) {
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

#if SEGMENTS > 1
vec3 litColour(GrassBlade blade, Spine spine, float s, vec3 n, vec3 towardsEdge, vec3 v, float share) {
  vec2 shade = unpackHalf2x16(blade.shade);
  vec4 tint = unpackUnorm4x8(blade.tint);
  float height = unpackHalf2x16(blade.sizes).x;
  // How deep in the canopy: it bends down as a whole, so the place along the blade counts, not the height.
  float canopy = clamp(s * height / (grass.baseColour.w * share), 0.0, 1.0);
  // Where the meadow thins out at its margin blades stand in the open.
  canopy = mix(1.0, canopy, smoothstep(0.25, 0.7, share));
  GrassLight at;
  at.height = canopy;
  at.dense = grass.levels.z;
  at.sunlit = smoothstep(-0.15, 0.15, spine.position.y - shade.x);
  at.shade = heightWindShade(spine.position.y / height, shade.y) * mix(tint.a, 1.0, 0.5 * canopy);
  vec3 albedo = laidAlbedo(bladeAlbedo(s, tint.r, 2.0 * tint.g, 2.0 * tint.b - 1.0), spine.tangent);
  return lightBlade(albedo, normalize(n + 0.55 * towardsEdge), spine.tangent, v, at);
}
#endif

void main() {
  GrassBlade blade = blades[listStart + uint(gl_InstanceID)];
  int row = gl_VertexID / 2;
  float s = float(row) / float(SEGMENTS);
  float edge = row == SEGMENTS ? 0.0 : (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  vec2 sizes = unpackHalf2x16(blade.sizes);
  vec2 facing = unpackSnorm4x8(blade.facing).xy;
  float rootHeight = mix(frame.groundRange.x, frame.groundRange.y, float(blade.facing >> 16u) / 65535.0);
  Spine spine = spineAt(blade, s, facing, sizes.x);
  vec3 centre = vec3(blade.x, rootHeight, blade.z) + spine.position;
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

  float taper = SEGMENTS == 1 ? 1.3 : 1.0 - 0.9 * s * s;
  vec3 world = centre + side * (edge * 0.5 * sizes.y * taper);
  gl_Position = frame.viewProjection * vec4(world, 1.0);

  vec4 canopyShare = unpackUnorm4x8(blade.canopy);
  // From afar: the meadow's colour, darker at the foot and lighter at the tip.
  vec3 afar = canopyShare.yzw * mix(0.80, 1.14, s);
#if SEGMENTS == 1
  bladeColour = afar;
#else
  vec3 lit = litColour(blade, spine, s, n, side * edge, v, canopyShare.x * 2.0);
  float tall = sizes.x * pixelsPerMetre(centre);
  bladeColour = mix(toPicture(throughAir(lit, world)), afar, smoothstep(2.2 * grass.levels.y, grass.levels.y, tall));
  bladePlace = vec2(edge, s);
#endif
}
