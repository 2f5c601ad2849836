#version 450 core
// The area that an arrow drives, as a mesh over its capsule or end disc.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

layout(std430, binding = RENDER_SSBO_MARKS) readonly buffer Marks { OverlayMark marks[]; };
uniform vec2 lift;
uniform int segments;  // along it; a third as many across, at least 1

out vec2 areaPlace;        // m along from the start and aside
out float areaLevel;       // place in the table of signal levels
flat out vec4 areaLook;
flat out vec4 areaSizes;   // start, end along, first and last place in the table

void main() {
  OverlayMark mark = marks[gl_InstanceID];
  int rows = max(segments / 3, 1);
  int quad = gl_VertexID / 6;
  int corner = int[6](0, 1, 2, 2, 1, 3)[gl_VertexID % 6];
  vec2 share = (vec2(quad % segments, quad / segments) + vec2(corner & 1, corner >> 1)) / vec2(segments, rows);
  vec2 span = mark.place.zw - mark.place.xy;
  float len = max(length(span), 1e-4);
  vec2 along = span / len;
  vec2 aside = vec2(-along.y, along.x);
  float start = mark.more.x > 0.5 ? len : 0.0;
  float radius = mark.look.x * 1.05;
  areaPlace = vec2(mix(start - radius, len + radius, share.x), mix(-radius, radius, share.y));
  areaLevel = mark.signal.x + mark.signal.y * areaPlace.x / len;
  areaLook = mark.look;
  areaSizes = vec4(start, len, mark.signal.x, mark.signal.x + mark.signal.y);
  gl_Position = clipWithLead(overGround(mark.place.xy + along * areaPlace.x + aside * areaPlace.y, lift.x), lift.y);
}
