#version 450 core
// The ground as rings of quads around the camera, fine near it, out to the horizon.
#include "shaders/include/frame.glsl"

uniform float rings[6];
const int kSectors = 24;
const int kCorners[6] = int[6](0, 1, 2, 2, 1, 3);

out vec3 groundWorld;

void main() {
  int quad = gl_VertexID / 6;
  int corner = kCorners[gl_VertexID % 6];
  int ring = quad / kSectors + (corner >> 1);
  int sector = quad % kSectors + (corner & 1);
  float turn = 6.2831853 * float(sector) / float(kSectors);
  vec2 at = frame.cameraPosition.xz + rings[ring] * vec2(cos(turn), sin(turn));
  groundWorld = vec3(at.x, 0.0, at.y);
  gl_Position = frame.viewProjection * vec4(groundWorld, 1.0);
}
