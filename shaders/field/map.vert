#version 450 core
// The seen part of the field as a mesh on the ground: a strip for each row.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

uniform vec4 area;     // low corner x, z and size x, z, m
uniform int columns;   // quads a side
uniform vec2 lift;     // m over the ground, m that the depth leads
out vec2 mapWorld;

void main() {
  vec2 node = vec2(gl_VertexID >> 1, gl_InstanceID + (gl_VertexID & 1));
  mapWorld = area.xy + area.zw * node / float(columns);
  gl_Position = clipWithLead(overGround(mapWorld, lift.x), lift.y);
}
