#version 450 core
// Points and probes: a disc on the ground, never smaller than a few pixels, as wide as the arrows that meet there; a
// probe has a mast too.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

layout(std430, binding = RENDER_SSBO_MARKS) readonly buffer Marks { OverlayMark marks[]; };
uniform vec2 lift;  // m over the ground, m that the depth leads

out vec2 pointPlace;  // -1..1
flat out vec2 pointKind;  // MARK_*, state
flat out float pointMast;

void main() {
  OverlayMark mark = marks[gl_InstanceID];
  bool mast = gl_VertexID >= 6;
  int corner = int[6](0, 1, 2, 2, 1, 3)[gl_VertexID % 6];
  pointPlace = vec2(corner & 1, corner >> 1) * 2.0 - 1.0;
  pointKind = vec2(mark.place.w, mark.look.w);
  pointMast = mast ? 1.0 : 0.0;
  float radius = discRadius(mark.place.z, mark.place.w, mark.place.xy);
  // As high as the edges of the arrows, where its handle lies; the depth leads past the ridges that end at its rim.
  vec3 foot = overGround(mark.place.xy, lift.x);
  vec3 world = overGround(mark.place.xy + pointPlace * radius, lift.x);
  if (mast) {
    vec3 v = directionToCamera(foot);
    vec3 aside = normalize(cross(vec3(0.0, 1.0, 0.0), v) + vec3(1e-5, 0.0, 0.0));
    world = foot + aside * pointPlace.x * 0.09 * radius + vec3(0.0, (0.5 + 0.5 * pointPlace.y) * 2.6 * radius, 0.0);
    if (mark.place.w != MARK_PROBE) world = foot;
  }
  gl_Position = clipWithLead(world, mast ? lift.y : lift.y + radius);
}
