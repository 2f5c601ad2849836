#version 450 core
// Tests the blades of the listed patches (Jahrmann & Wimmer, 2017, eq. 17-20 and against depth) and makes those that pass
// ready to be drawn, each in the list of its detail. A work-group looks after a patch.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/ground.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/meadow.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/atmosphere.glsl"
#include "shaders/include/tone_map.glsl"
#include "shaders/include/occluders.glsl"
#include "shaders/include/grass_maps.glsl"
#include "shaders/include/grass_tiles.glsl"
#include "shaders/include/colliders.glsl"
#include "shaders/include/blade_light.glsl"
#include "shaders/include/bezier_lanes.glsl"
#include "shaders/include/bezier_work.glsl"
#include "shaders/shared/bezier_cull.h"
#include "shaders/shared/bezier_pose.h"
#include "shaders/shared/hash.h"

layout(local_size_x = LANES) in;
layout(std430, binding = RENDER_SSBO_BEZIER_BLADES) readonly buffer Blades { BezierBlade blades[]; };
layout(std430, binding = RENDER_SSBO_BEZIER_STATES) readonly buffer States { BezierState states[]; };
// Places of records, a run for each list.
layout(std430, binding = RENDER_SSBO_BEZIER_LIST) writeonly buffer Lists { uint lists[]; };
layout(std430, binding = RENDER_SSBO_BEZIER_DRAWN) writeonly buffer Drawn { BezierDrawn drawn[]; };
layout(binding = RENDER_TEXTURE_NEAR_DEPTH) uniform sampler2D nearDepth;
uniform uint round;  // 0: large blades and the first ones of other patches, 1: the rest
uniform uint hides;  // 1: what is drawn already hides blades (nearDepth)

shared uint groupCounts[8];
shared uint listCounts[BEZIER_LISTS];
shared uint listStarts[BEZIER_LISTS];
shared uint recordCount, recordStart;

const uint kDrawn = BEZIER_COUNT_DRAWN;
// A place is hidden where it lies so far behind what is drawn already, m.
const float kHiddenBias = 0.06;
const float kFootLit = 0.2, kTipLit = 0.7;
const float kMeanLit = 0.44;

// What the tests look at.
struct Standing {
  vec3 root, up, across;
  BezierCurve curve;
  vec2 sizes;  // height, width m
  vec3 middle;  // of the curve, from the root
};

Standing standingOf(BezierBlade blade, BezierState state) {
  Standing s;
  s.root = vec3(blade.x, blade.y, blade.z);
  s.up = octahedralVector(unpackSnorm2x16(blade.up));
  s.sizes = unpackHalf2x16(blade.sizes);
  s.across = bezierAcross(s.up, float(blade.growth >> 16u) / 65535.0);
  s.curve = bezierValid(state.tip.xyz, s.up, s.sizes.x);
  s.middle = bezierPoint(s.curve, 0.5);
  return s;
}

// Eq. 18, widened by what a blade is wide.
bool outsideView(Standing s) {
  vec3 places[3] = vec3[](s.root, s.root + s.middle, s.root + s.curve.tip);
  for (int i = 0; i < 3; ++i) {
    vec4 clip = frame.viewProjection * vec4(places[i], 1.0);
    vec2 tolerance = 2.0 * s.sizes.y * frame.pixelScale.x * 2.0 * frame.viewport.zw + 2.0 * frame.viewport.zw * clip.w;
    if (insideClip(clip, tolerance)) return false;
  }
  return true;
}

bool hiddenAt(vec3 place) {
  vec3 nearer = place + directionToCamera(place) * kHiddenBias;
  vec4 clip = frame.viewProjection * vec4(nearer, 1.0);
  vec2 uv = 0.5 + 0.5 * clip.xy / clip.w;
  if (clip.w <= 0.0 || any(lessThan(uv, vec2(0.0))) || any(greaterThanEqual(uv, vec2(1.0)))) return false;
  return 0.5 + 0.5 * clip.z / clip.w > texelFetch(nearDepth, ivec2(uv * frame.viewport.xy) / 2, 0).r;
}

bool occluded(Standing s) {
  vec3 tip = s.root + s.curve.tip;
  vec3 low = min(min(s.root, s.root + s.curve.middle), tip);
  vec3 high = max(max(s.root, s.root + s.curve.middle), tip);
  if (isOccluded(0.5 * (low + high), 0.5 * (high - low))) return true;
  if (hides == 0u) return false;
  return hiddenAt(tip) && hiddenAt(s.root + bezierPoint(s.curve, 0.8)) && hiddenAt(s.root + s.middle) && hiddenAt(s.root);
}

// The first test that leaves the blade out, kDrawn: none. `width`: part of its width that it keeps, times its widening.
uint testOf(Standing s, float rank, out float width) {
  width = 1.0;
  if (bezier.tests.x > 0.5) {
    width = seenFromSide(s.across, -directionToCamera(s.root), bezier.cull.x);
    if (width <= 0.0) return BEZIER_COUNT_ORIENTATION;
  }
  if (bezier.tests.y > 0.5 && outsideView(s)) return BEZIER_COUNT_FRUSTUM;
  if (bezier.tests.z > 0.5) {
    float away = isOrthographic() ? 0.0 : distanceOverGround(s.root, s.up, frame.cameraPosition.xyz);
    float kept = keptAtDistance(away, bezier.cull.y, s.sizes.y * pixelsPerMetre(s.root), bezier.cull.w);
    float grown = grownAtRank(rank, kept, bezier.cull.z);
    if (grown <= 0.0) return BEZIER_COUNT_DISTANCE;
    width *= grown * keptWidening(kept, bezier.cull.z);
  }
  return bezier.tests.w > 0.5 && occluded(s) ? BEZIER_COUNT_OCCLUSION : kDrawn;
}

uint listOf(BezierBlade blade, float tallPixels) {
  if (blade.look >> 24u == BEZIER_FORM_DANDELION) return BEZIER_DANDELION_LIST + (tallPixels > bezier.levels.y ? 0u : 1u);
  return tallPixels > bezier.levels.x ? 0u : tallPixels > bezier.levels.y ? 1u : tallPixels > bezier.levels.z ? 2u : 3u;
}

vec3 hueOf(uint hash) {
  float turn = 6.2831853 * hashToUnit(hash);
  return 0.5 + 0.4 * vec3(cos(turn), cos(turn - 2.0944), cos(turn - 4.1888));
}

vec3 testColour(uint test) {
  return test == BEZIER_COUNT_ORIENTATION ? vec3(0.95, 0.75, 0.10) : test == BEZIER_COUNT_FRUSTUM ? vec3(0.85, 0.20, 0.75) :
         test == BEZIER_COUNT_DISTANCE ? vec3(0.20, 0.45, 0.95) : test == BEZIER_COUNT_OCCLUSION ? vec3(0.90, 0.15, 0.10) : vec3(0.25, 0.65, 0.25);
}

vec3 strengthColour(float strength) { return mix(vec3(0.10, 0.13, 0.16), mix(vec3(0.95, 0.55, 0.10), vec3(1.0, 0.95, 0.75), clamp(strength - 1.0, 0.0, 1.0)), clamp(strength, 0.0, 1.0)); }

BladeLook lookOf(BezierBlade blade, Standing s, bool onGround) {
  vec4 look = unpackUnorm4x8(blade.look);
  BladeLook found;
  found.species = 0u;
  found.height = s.sizes.x;
  found.canopy = s.sizes.x;
  found.closed = 1.0;
  vec3 middle = s.root + s.middle;
  float open = 1.0;
  float dry = look.r;
  float bright = 2.0 * look.g;
  // A surface shades the blades on its back; on the ground hills and solids do.
  found.shadowHeight = mix(2.0, -2.0, smoothstep(-0.12, 0.2, dot(s.up, frame.sunDirection.xyz))) * s.sizes.x;
  if (onGround) {
    SolidsNear solids = solidsNear(s.root.xz);
    GroundLight ground = groundLight(s.root.xz, pixelsPerMetre(s.root));
    found.shadowHeight = max(solids.shadowHeight, softened(ground.shadowHeight));
    open = openness(solids.distanceM);
    vec2 broad = meadowPatch(s.root.xz);
    dry = clamp(dry + 0.15 * broad.x, 0.0, 1.0);
    bright *= broad.y;
    found.ground = ground.normal;
    found.colour = mapColour(s.root.xz);
    // Lower, and in the open, in the margin around the field, as they grow there.
    float margin = smoothstep(0.0, 0.8, beyondField(s.root.xz) / grass.tileCentre.z);
    float share = mapHeight(s.root.xz) * mix(1.0, 0.3, margin);
    found.canopy = canopyOf(share);
    found.closed = closedOf(share);
  } else {
    found.ground = s.up;
    found.colour = vec3(1.0);
    open = 0.6 + 0.4 * s.up.y;
  }
  float sunlit = smoothstep(-0.15, 0.15, 0.3 * s.sizes.x - found.shadowHeight);
  bright *= slopeLight(found.ground, sunlit) * (onGround ? colliderShade(middle) : colliderShadeOnSurface(middle));
  vec2 felt = smoothWind(s.root.xz);
  found.force = shadeForce(length(felt));
  found.tint = vec4(dry, 0.5 * bright, look.b, open);
  return found;
}

vec3 litAt(BladeLook look, Standing s, uint form, float v, vec3 eye) {
  vec3 a = s.curve.middle * v;
  vec3 b = mix(s.curve.middle, s.curve.tip, v);
  vec3 tangent = normalize(b - a + s.up * 1e-5);
  float rise = dot(mix(a, b, v), s.up);
  if (form == BEZIER_FORM_DANDELION) look.colour = dandelionColour(look.colour, v);
  return 0.5 * (bladeLight(look, rise, tangent, v, s.across, -0.7, eye, s.up) + bladeLight(look, rise, tangent, v, s.across, 0.7, eye, s.up));
}

BezierDrawn recordOf(BezierBlade blade, BezierState state, Standing s, bool onGround, float width, uint test, uint patchIndex) {
  BladeLook look = lookOf(blade, s, onGround);
  uint form = blade.look >> 24u;
  BezierDrawn made;
  made.x = s.root.x;
  made.y = s.root.y;
  made.z = s.root.z;
  made.up = blade.up;
  made.tip = packHalf2x16(s.curve.tip.xy);
  made.curve = packHalf2x16(vec2(s.curve.tip.z, dot(s.curve.middle, s.up)));
  made.sizes = packHalf2x16(vec2(s.sizes.x, s.sizes.y * width * bezier.patches.z));
  made.growth = blade.growth;
  made.look = packUnorm4x8(vec4(look.tint.r, 0.0, look.tint.b, 0.0)) & 0x00ffffffu | blade.look & 0xff000000u;
  made.shade = packHalf2x16(vec2(look.shadowHeight, look.force));
  made.light = packUnorm4x8(vec4(look.tint.g, look.tint.a, 0.5 * min(look.canopy / s.sizes.x, 2.0), look.closed));
  vec3 foot, tip;
  if (bezier.view.x == BEZIER_VIEW_NORMAL) {
    vec3 eye = directionToCamera(s.root + s.middle);
    foot = toPicture(throughAir(litAt(look, s, form, kFootLit, eye), s.root));
    tip = toPicture(throughAir(litAt(look, s, form, form == BEZIER_FORM_DANDELION ? 0.95 : kTipLit, eye), s.root));
    // A blade narrower than a pixel is seen as a whole.
    float single = clamp(s.sizes.y * width * pixelsPerMetre(s.root), 0.0, 1.0);
    vec3 mean = mix(foot, tip, kMeanLit);
    foot = mix(mean, foot, mix(0.4, 1.0, single));
    tip = mix(mean, tip, mix(0.4, 1.0, single));
  } else {
    vec3 colour = bezier.view.x == BEZIER_VIEW_PATCHES ? hueOf(pcgHash(patchIndex)) :
                  bezier.view.x == BEZIER_VIEW_CULLED ? testColour(test) : strengthColour(state.tip.w);
    foot = 0.45 * colour;
    tip = colour;
  }
  made.foot = packUnorm4x8(vec4(foot, 0.0));
  made.top = packUnorm4x8(vec4(tip, 0.0));
  return made;
}

void main() {
  uint lane = gl_LocalInvocationIndex;
  if (lane < 8u) groupCounts[lane] = 0u;
  if (lane < BEZIER_LISTS) listCounts[lane] = 0u;
  if (lane == 0u) recordCount = 0u;
  barrier();
  uint patchIndex = seen[round == 0u ? patchesNear(gl_WorkGroupID.x) : patchesFar(gl_WorkGroupID.x)];
  BezierPatch part = patches[patchIndex];
  bool onGround = part.reach.w < -0.5;
  uint index = patchIndex * BEZIER_PATCH + lane;
  float shownOf = float(shownBlades(part));
  bool exists = float(lane) < shownOf;
  bool first = seen[patchIndex] == BEZIER_SEEN_LARGE || lane < uint(bezier.view.z * shownOf);
  exists = exists && first == (round == 0u);
  bool shown = false;
  BezierDrawn record;
  uint list = 0u, recordAt = 0u, listAt = 0u;
  if (exists) {
    BezierBlade blade = blades[index];
    BezierState state = states[index];
    Standing s = standingOf(blade, state);
    float width;
    uint test = testOf(s, (float(lane) + 0.5) / shownOf, width);
    if (onGround && solidsNear(s.root.xz).distanceM < 0.02) test = BEZIER_COUNT_BURIED;
    atomicAdd(groupCounts[test], 1u);
    bool reveal = bezier.view.x == BEZIER_VIEW_CULLED && test != BEZIER_COUNT_BURIED;
    shown = test == kDrawn || reveal;
    if (shown) {
      if (reveal && test != kDrawn) width = 1.0;
      record = recordOf(blade, state, s, onGround, width, test, patchIndex);
      list = listOf(blade, s.sizes.x * pixelsPerMetre(s.root));
      recordAt = atomicAdd(recordCount, 1u);
      listAt = atomicAdd(listCounts[list], 1u);
    }
  }
  barrier();
  if (lane < 8u && groupCounts[lane] > 0u) atomicAdd(commands.counts[lane], groupCounts[lane]);
  if (lane == 0u) recordStart = atomicAdd(commands.records, recordCount);
  if (lane < BEZIER_LISTS && listCounts[lane] > 0u) {
    listStarts[lane] = atomicAdd(commands.ends[lane], listCounts[lane]);
    uint shownInList = min(listStarts[lane] + listCounts[lane], uint(bezier.view.y)) - commands.starts[lane];
    atomicMax(commands.draws[lane * 5u + 1u], (shownInList + BEZIER_CHUNK - 1u) / BEZIER_CHUNK);
  }
  barrier();
  uint room = uint(bezier.view.y);
  if (shown && listStarts[list] + listAt < room) {
    bool fits = recordStart + recordAt < room;
    if (fits) drawn[recordStart + recordAt] = record;
    lists[list * room + listStarts[list] + listAt] = fits ? recordStart + recordAt : BEZIER_NO_RECORD;
  }
}
