#version 450 core
// Wind vectors on a lattice that stands still in the world: one instance a node, length and colour by speed.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/overlay.glsl"

uniform vec4 lattice;   // first node x, z and spacing, m; w m over the ground
uniform int columns;

out vec3 vectorColour;
out vec2 vectorPlace;  // along, across: for smooth edges

// A slender arrow: shaft quad and head, in units of its length (x) and width (y).
const vec2 kShape[9] = vec2[9](vec2(0.0, -0.35), vec2(0.62, -0.35), vec2(0.0, 0.35), vec2(0.0, 0.35), vec2(0.62, -0.35),
                               vec2(0.62, 0.35), vec2(0.55, -1.0), vec2(1.0, 0.0), vec2(0.55, 1.0));

void main() {
  vec2 node = lattice.xy + vec2(gl_InstanceID % columns, gl_InstanceID / columns) * lattice.z;
  vec2 wind = smoothWind(node);
  float speed = length(wind);
  float part = speed / frame.pixelScale.z;
  vec2 along = speed > 1e-4 ? wind / speed : vec2(1.0, 0.0);
  vec2 aside = vec2(-along.y, along.x);
  // Calm air shows as a dot; the strongest vectors nearly meet.
  float len = lattice.z * clamp(0.10 + 0.95 * part, 0.10, 1.15);
  float wide = min(lattice.z * 0.12, 0.5 * len);
  vec2 shape = kShape[gl_VertexID];
  vec2 at = node + along * len * (shape.x - 0.5) + aside * wide * shape.y;
  vectorColour = speedColourAt(part);
  vectorPlace = shape;
  gl_Position = frame.viewProjection * vec4(at.x, lattice.w, at.y, 1.0);
}
