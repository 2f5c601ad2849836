#version 450 core
// A streamline as a ribbon that faces the camera, wide at its head.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"
#include "shaders/shared/flow_seed.h"

layout(std430, binding = RENDER_SSBO_LINES) readonly buffer Lines { vec4 lines[]; };
uniform vec2 lift;  // m over the ground, m that the depth leads

out vec2 linePlace;  // 0 tail to 1 head; -1..1 across
out vec2 lineLook;   // part of the speed range, alpha

void main() {
  int first = gl_InstanceID * FLOW_LINE_POINTS;
  int i = gl_VertexID >> 1;
  vec4 point = lines[first + i];
  vec4 last = lines[first + FLOW_LINE_POINTS - 1];
  linePlace = vec2(float(i) / float(FLOW_LINE_POINTS - 1), float(gl_VertexID & 1) * 2.0 - 1.0);
  lineLook = vec2(point.z, point.w);
  vec4 start = lines[first];
  if (start.w <= 0.0) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  vec2 before = lines[first + max(i - 1, 0)].xy, after = lines[first + min(i + 1, FLOW_LINE_POINTS - 1)].xy;
  vec3 world = overGround(point.xy, lift.x);
  vec3 along = overGround(after, lift.x) - overGround(before, lift.x);
  vec3 side = cross(along, directionToCamera(world));
  float size = length(side);
  side = size > 1e-6 ? side / size : vec3(0.0);
  float pixels = pixelUnit() * mix(1.0, 2.5, linePlace.x) * (0.8 + 0.4 * min(point.z, 1.0));
  gl_Position = clipWithLead(world + side * linePlace.y * pixels / max(pixelsPerMetre(world), 1e-3), lift.y);
}
