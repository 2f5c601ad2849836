#version 450 core
// The upper edge of an obstacle as a band of constant width on screen.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"
#include "shaders/shared/solid.h"

layout(std430, binding = RENDER_SSBO_MARKS) readonly buffer Marks { OverlayMark marks[]; };
flat out float outlineState;
const int kSectors = 32;

vec2 outline(int sector, float shape) {
  float turn = float(sector) / float(kSectors);
  if (shape == SOLID_CIRCLE) return vec2(cos(6.2831853 * turn), sin(6.2831853 * turn));
  float at = fract(turn) * 4.0;
  float t = fract(at) * 2.0 - 1.0;
  return at < 1.0 ? vec2(1.0, t) : at < 2.0 ? vec2(-t, 1.0) : at < 3.0 ? vec2(-1.0, -t) : vec2(t, -1.0);
}

void main() {
  OverlayMark mark = marks[gl_InstanceID];
  int sector = gl_VertexID >> 1;
  float wide = metresFor(pixelUnit() * (mark.look.w == MARK_NORMAL ? 1.5 : 3.0), mark.place.xy);
  if (mark.more.x == SOLID_POLYGON) {
    // A side of its own, in the middle of the band; a little longer, so that sides meet at corners.
    vec2 way = normalize(mark.place.zw - mark.place.xy);
    vec2 at = mix(mark.place.xy, mark.place.zw, float(sector) / float(kSectors));
    if (sector == 0) at -= 0.5 * wide * way;
    if (sector == kSectors) at += 0.5 * wide * way;
    at += ((gl_VertexID & 1) == 0 ? -0.5 : 0.5) * wide * vec2(way.y, -way.x);
    outlineState = mark.look.w;
    gl_Position = frame.viewProjection * vec4(at.x, groundHeight(mark.more.yz) + mark.look.z + 0.02, at.y, 1.0);
    return;
  }
  vec2 halfSize = mark.place.zw + ((gl_VertexID & 1) == 0 ? 0.0 : wide);
  vec2 local = outline(sector, mark.more.x) * halfSize;
  vec2 at = mark.place.xy + vec2(mark.look.x * local.x - mark.look.y * local.y, mark.look.y * local.x + mark.look.x * local.y);
  outlineState = mark.look.w;
  // The edge is level, on its solid's foot.
  float foot = groundHeight(mark.place.xy);
  gl_Position = frame.viewProjection * vec4(at.x, foot + mark.look.z + 0.02, at.y, 1.0);
}
