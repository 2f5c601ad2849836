#version 450 core
// A quad over the part of the map that a solid reaches: its surroundings and its shadow.
#include "shaders/include/frame.glsl"
#include "shaders/include/solid_shape.glsl"

const float kReachM = 4.0;
const float kMostDropM = 25.0;  // downhill shadows are cut where the ground lies lower than this
flat out int solidIndex;
out vec2 mapWorld;

void main() {
  Solid solid = solids[gl_InstanceID];
  float half0 = length(solid.place.zw) + kReachM;
  float shadow = (solid.level.y - max(frame.groundRange.x, solid.level.x - kMostDropM)) * length(frame.sunDirection.xz) / max(frame.sunDirection.y, 0.05);
  vec2 away = -normalize(frame.sunDirection.xz) * shadow;
  vec2 low = solid.place.xy - half0 + min(away, vec2(0.0));
  vec2 high = solid.place.xy + half0 + max(away, vec2(0.0));
  mapWorld = mix(low, high, vec2(gl_VertexID & 1, gl_VertexID >> 1));
  solidIndex = gl_InstanceID;
  gl_Position = vec4((mapWorld - frame.solidMap.xy) * frame.solidMap.zw * 2.0 - 1.0, 0.0, 1.0);
}
