#version 450 core
// One triangle that covers the target.
out vec2 screenUv;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  screenUv = corner * 0.5 + 0.5;
  gl_Position = vec4(corner, 1.0, 1.0);
}
