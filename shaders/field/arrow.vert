#version 450 core
// An arrow as a solid ridge lying on the tips of the grass: tail, two shaft faces, two head faces.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

layout(std430, binding = RENDER_SSBO_MARKS) readonly buffer Marks { OverlayMark marks[]; };
uniform float height;  // m over the ground

out vec3 arrowNormal;
out vec2 arrowPlace;  // m along and share across (-1..1)
flat out vec4 arrowLook;
flat out vec2 arrowSizes;  // length, muted

// Corners: 0 tail left, 1 tail ridge, 2 tail right, 3 neck left, 4 neck ridge, 5 neck right, 6 barb left,
// 7 barb ridge, 8 barb right, 9 tip. Faces wind counter-clockwise from above.
const int kFaces[27] = int[27](0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 6, 7, 9, 7, 8, 9, 6, 7, 3, 7, 8, 5, 0, 2, 1);

void main() {
  OverlayMark mark = marks[gl_InstanceID];
  vec2 span = mark.place.zw - mark.place.xy;
  float len = max(length(span), 1e-4);
  vec2 along = span / len;
  vec2 aside = vec2(-along.y, along.x);
  float least = metresFor(2.2, mark.place.xy + 0.5 * span);
  float wide = max(clamp(0.16 * mark.look.x, 0.12, 0.9), least) * (mark.look.w == MARK_NORMAL ? 1.0 : 1.2);
  wide = min(wide, 0.22 * len);
  float head = min(3.6 * wide, 0.55 * len);
  int corner = kFaces[gl_VertexID];
  int place = corner < 3 ? 0 : corner < 9 ? 1 : 2;
  float across = corner == 1 || corner == 4 || corner == 7 || corner == 9 ? 0.0 : corner == 0 || corner == 3 || corner == 6 ? -1.0 : 1.0;
  float reach = corner >= 6 && corner < 9 ? 2.4 * wide : wide;
  float s = place == 0 ? 0.0 : place == 1 ? len - head : len;
  if (corner == 6 || corner == 8) s -= 0.25 * head;
  vec2 at = mark.place.xy + along * s + aside * across * reach;
  float y = height + (across == 0.0 && place != 2 ? 0.75 * wide : 0.0);
  // Faces of one side share a normal: the ridge's slope.
  int face = gl_VertexID / 3;
  float side = face == 8 ? 0.0 : face == 0 || face == 1 || face == 4 || face == 6 ? -1.0 : 1.0;
  arrowNormal = face == 8 ? vec3(-along.x, 0.3, -along.y) : normalize(vec3(aside.x * side, 1.3, aside.y * side));
  arrowPlace = vec2(s, across);
  arrowLook = mark.look;
  arrowSizes = vec2(len, mark.more.y);
  gl_Position = frame.viewProjection * vec4(at.x, y, at.y, 1.0);
}
