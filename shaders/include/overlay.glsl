// What the overlay passes share. They draw in picture colours (sRGB), premultiplied, over the scene's depth, and
// follow the ground. Needs frame.glsl.
#include "shaders/include/ground.glsl"
#include "shaders/shared/overlay_mark.h"
#include "shaders/shared/speed_colour.h"

// The accent colours of hovered and selected things; the same as the editor's.
const vec3 kHoverColour = vec3(1.0, 0.93, 0.74);
const vec3 kSelectColour = vec3(1.0, 0.62, 0.12);

vec3 markColour(vec3 own, float state) {
  return state == MARK_SELECTED ? mix(own, kSelectColour, 0.85) : state == MARK_HOVERED ? mix(own, kHoverColour, 0.6) : own;
}

vec3 overGround(vec2 place, float height) { return vec3(place.x, groundHeight(place) + height, place.y); }

// m that a mark must measure to cover `pixels` at a place.
float metresFor(float pixels, vec2 place) { return pixels / max(pixelsPerMetre(overGround(place, 0.0)), 1e-3); }

// Pixels of marks grow with large pictures and shrink with small ones.
float pixelUnit() { return clamp(frame.viewport.y / 500.0, 0.5, 2.0); }

// Clip position of a place whose depth counts as if it lay `lead` m nearer: what lies on the tips of the grass is
// then not lost behind single blades, but still behind stones and hills.
vec4 clipWithLead(vec3 world, float lead) {
  vec4 clip = frame.viewProjection * vec4(world, 1.0);
  float nearby = isOrthographic() ? lead : min(lead, 0.5 * clip.w);
  if (nearby <= 0.0) return clip;
  vec4 nearer = frame.viewProjection * vec4(world - frame.viewForward.xyz * nearby, 1.0);
  clip.z = nearer.z / nearer.w * clip.w;
  return clip;
}

// Radius in m of the disc of a point; arrows end at its rim.
float discRadius(float hub, float kind, vec2 place) {
  return max(hub * (kind == MARK_POINT ? 1.0 : 1.3), metresFor(kind == MARK_POINT ? 6.0 : 8.0, place));
}
