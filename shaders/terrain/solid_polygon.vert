#version 450 core
// A solid with any outline: triangles made by engine/render/polygon_mesh.cpp.
#include "shaders/include/frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in float height;

out vec3 stoneWorld;
out vec3 stoneNormal;
flat out float stoneHeight;

void main() {
  stoneWorld = position;
  stoneNormal = normal;
  stoneHeight = height;
  gl_Position = frame.viewProjection * vec4(stoneWorld, 1.0);
}
