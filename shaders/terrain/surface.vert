#version 450 core
// A thing that grass grows on: its mesh.
#include "shaders/include/frame.glsl"

uniform mat4 world;  // from its own metres

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 surfaceWorld;
out vec3 surfaceNormal;

void main() {
  surfaceWorld = (world * vec4(position, 1.0)).xyz;
  surfaceNormal = mat3(world) * normal;
  gl_Position = frame.viewProjection * vec4(surfaceWorld, 1.0);
}
