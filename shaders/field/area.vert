#version 450 core
// The area that an arrow drives, as a quad around its capsule or end disc.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

layout(std430, binding = RENDER_SSBO_MARKS) readonly buffer Marks { OverlayMark marks[]; };
uniform float height;

out vec2 areaPlace;        // m along from the start and aside
flat out vec4 areaLook;
flat out vec4 areaSizes;   // start, end along, muted

void main() {
  OverlayMark mark = marks[gl_InstanceID];
  vec2 span = mark.place.zw - mark.place.xy;
  float len = max(length(span), 1e-4);
  vec2 along = span / len;
  vec2 aside = vec2(-along.y, along.x);
  float start = mark.more.x > 0.5 ? len : 0.0;
  float radius = mark.look.x * 1.05;
  areaPlace = vec2(mix(start - radius, len + radius, float(gl_VertexID & 1)), (gl_VertexID >> 1) == 0 ? -radius : radius);
  areaLook = mark.look;
  areaSizes = vec4(start, len, mark.more.y, 0.0);
  vec2 at = mark.place.xy + along * areaPlace.x + aside * areaPlace.y;
  gl_Position = frame.viewProjection * vec4(at.x, height, at.y, 1.0);
}
