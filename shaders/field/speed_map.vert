#version 450 core
// The field's rectangle.
#include "shaders/include/frame.glsl"
uniform float height;
out vec2 mapWorld;

void main() {
  mapWorld = frame.field.xy + frame.field.zw * vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = frame.viewProjection * vec4(mapWorld.x, height, mapWorld.y, 1.0);
}
